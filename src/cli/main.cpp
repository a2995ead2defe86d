// Choosing the command; nothing thrown leaves it.
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include <tetloft/version.hpp>

#include "cli/commands.hpp"
#include "cli/signals.hpp"
#include "io/numbers.hpp"

namespace tetloft::cli {

namespace {

std::vector<Command> all_commands() {
  return {reconstruct_command(), check_command(),  delaunay_command(),
          skeleton_command(),    render_command(), info_command()};
}

std::string general_help() {
  std::string text =
      "usage: tetloft COMMAND …\n\n"
      "Solids from planar cross sections.\n\ncommands:\n";
  for (const Command& command : all_commands()) {
    std::string name = "  " + std::string(command.usage.command);
    name.resize(16, ' ');
    text += name + std::string(command.usage.summary) + '\n';
  }
  text +=
      "\n  --help        print this help; tetloft COMMAND --help tells more\n"
      "  --version     print the version\n\n"
      "exit codes: 0 done, 1 check: a guarantee fails, 2 usage, 3 invalid input,\n"
      "4 a file cannot be read or written, 5 no valid model representable, 7 over the\n"
      "work limit, 70 internal error, 71 out of memory, 72 arithmetic unfit for exact\n"
      "predicates\n";
  return text;
}

Result<int> dispatch(const std::vector<std::string>& words, Console& console) {
  if (words.empty() || words.front() == "--json" || words.front() == "--quiet") {
    return usage_error("missing command; see tetloft --help");
  }
  const std::string& name = words.front();
  if (name == "--help" || name == "-h" || name == "help") {
    console.print(general_help());
    return 0;
  }
  if (name == "--version") {
    console.print(std::string("tetloft ") + version());
    return 0;
  }
  for (const Command& command : all_commands()) {
    if (command.usage.command != name) continue;
    const Result<Arguments> arguments =
        Arguments::parse(command.usage, {words.begin() + 1, words.end()});
    if (!arguments) return arguments.error();
    if (arguments->has("--help")) {
      console.print(help_text(command.usage));
      return 0;
    }
    return command.run(*arguments, console);
  }
  return usage_error("unknown command " + io::in_quotes(name) + "; see tetloft --help");
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
  int code = 0;
  try {
    const Result<int> result = dispatch(words, console);
    code = result ? *result : console.fail(result.error());
  } catch (const std::bad_alloc&) {
    code = console.fail({ErrorCode::out_of_memory, "out of memory", {}});
  } catch (const std::exception& e) {
    code = console.fail({ErrorCode::internal, e.what(), {}});
  } catch (...) {
    code = console.fail({ErrorCode::internal, "unknown exception", {}});
  }
  // A result that did not reach its reader is a file that could not be written.
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    console.say("error: standard output cannot be written" +
                (errno == 0 ? std::string() : ": " + std::generic_category().message(errno)));
    if (code == 0) code = static_cast<int>(ErrorCode::io);
  }
  return code;
}

}  // namespace

}  // namespace tetloft::cli

int main(int argc, char** argv) {
  tetloft::cli::handle_signals();
  try {
    return tetloft::cli::run({argv + (argc > 0 ? 1 : 0), argv + argc});
  } catch (...) {
    // Not even a message could be put together.
    std::fputs("tetloft: error: out of memory\n", stderr);
    return static_cast<int>(tetloft::ErrorCode::out_of_memory);
  }
}
