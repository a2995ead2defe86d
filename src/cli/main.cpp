// Choosing the command; nothing thrown leaves it.
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <cstdio>

#include <tetloft/version.hpp>

#include "cli/allocator.hpp"
#include "cli/commands.hpp"
#include "cli/file_formats.hpp"
#include "cli/help.hpp"
#include "cli/signals.hpp"
#include "cli/standard_streams.hpp"
#include "core/spelling.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

using namespace internal;

namespace {

Error unknown_command(const std::string& name, const std::vector<Command>& commands) {
  std::vector<std::string_view> names{"help", "--help", "--version"};
  for (const Command& command : commands) names.push_back(command.usage.command);
  std::string hint = did_you_mean(name, names);
  // A file where the command should be: the first thing that people try.
  if (has_input_extension(name, Contents::stack)) {
    hint = " (to make a solid: tetloft reconstruct " + input_word("IN", Contents::stack) + " -o " +
           output_word("OUT", Contents::model) + ')';
  } else if (has_input_extension(name, Contents::model)) {
    hint = " (to see a solid: tetloft render " + input_word("MODEL", Contents::model) +
           " -o OUT.html)";
  } else if (has_input_extension(name, Contents::surface)) {
    hint = " (to make a stack of a surface: tetloft slice " +
           input_word("MESH", Contents::surface) + " --planes N -o " +
           output_word("OUT", Contents::stack) + ')';
  }
  return usage_error("unknown command " + io::in_quotes(name) + hint + "; see tetloft --help");
}

Result<int> help(const std::vector<std::string>& words, Console& console) {
  std::string text = general_help();
  if (words.size() > 1 && words[1].rfind("--", 0) != 0) {
    const std::vector<Command> commands = all_commands();
    const Command* asked = nullptr;
    for (const Command& command : commands) {
      if (command.usage.command == words[1]) asked = &command;
    }
    if (asked == nullptr) return unknown_command(words[1], commands);
    text = help_text(asked->usage);
  }
  const Result<void> told = console.deliver(text);
  if (!told) return told.error();
  return 0;
}

Result<int> dispatch(const std::vector<std::string>& words, Console& console) {
  if (words.empty()) std::fputs((general_help() + '\n').c_str(), stderr);
  if (words.empty() || words.front() == "--json" || words.front() == "--quiet") {
    return usage_error("missing command; see tetloft --help");
  }
  const std::string& name = words.front();
  if (name == "--help" || name == "-h" || name == "help") return help(words, console);
  if (name == "--version") {
    const Result<void> told = console.deliver(std::string("tetloft ") + version());
    if (!told) return told.error();
    return 0;
  }
  const std::vector<Command> commands = all_commands();
  for (const Command& command : commands) {
    if (command.usage.command != name) continue;
    const Result<Arguments> arguments =
        Arguments::parse(command.usage, {words.begin() + 1, words.end()});
    if (!arguments) return arguments.error();
    if (arguments->has("--help")) return help({"help", name}, console);
    return command.run(*arguments, console);
  }
  return unknown_command(name, commands);
}

// Asked for even where the command line is wrong: its error must be JSON too.
bool asks_for(const std::vector<std::string>& words, const char* flag) {
  for (const std::string& word : words) {
    if (word == "--") return false;
    if (word == flag) return true;
  }
  return false;
}

int run(const std::vector<std::string>& words) {
  Console console(asks_for(words, "--json"), asks_for(words, "--quiet"));
  try {
    const Result<int> result = dispatch(words, console);
    if (!result) return console.fail(result.error());
    console.tell_rest();
    return *result;
  } catch (const std::bad_alloc&) {
    return console.fail({ErrorCode::out_of_memory, "out of memory", {}});
  } catch (const std::exception& e) {
    return console.fail({ErrorCode::internal, e.what(), {}});
  } catch (...) {
    return console.fail({ErrorCode::internal, "unknown exception", {}});
  }
}

}  // namespace

}  // namespace tetloft::cli

int main(int argc, char** argv) {
  tetloft::cli::handle_signals();
  tetloft::cli::keep_freed_memory();
  try {
    tetloft::cli::occupy_standard_streams();
    return tetloft::cli::run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (...) {
    // Not even a message could be put together.
    std::fputs("tetloft: error: out of memory\n", stderr);
    return static_cast<int>(tetloft::ErrorCode::out_of_memory);
  }
}
