// See help.hpp.
#include "cli/help.hpp"

#include <array>

#include "cli/file_formats.hpp"

namespace tetloft::cli {

namespace {

constexpr std::array kExitCodes{
    ExitCode{0, "done"},
    ExitCode{kGuaranteeFails, "check, report: a guarantee fails"},
    ExitCode{2, "usage"},
    ExitCode{3, "invalid input"},
    ExitCode{4, "a file cannot be read or written"},
    ExitCode{5, "no valid model representable"},
    ExitCode{7, "over the work limit"},
    ExitCode{70, "internal error"},
    ExitCode{71, "out of memory"},
    ExitCode{72, "arithmetic unfit for exact predicates"},
};

std::string exit_code_sentence() {
  std::string text = "exit codes: ";
  for (const ExitCode& exit : kExitCodes) {
    if (exit.code != 0) text += ", ";
    text += std::to_string(exit.code) + ' ' + std::string(exit.meaning);
  }
  return text;
}

}  // namespace

std::vector<Command> all_commands() {
  return {reconstruct_command(), check_command(),      links_command(),  between_command(),
          delaunay_command(),    skeleton_command(),   render_command(), report_command(),
          plan_command(),        join_command(),       info_command(),   convert_command(),
          slice_command(),       completion_command(), manual_command()};
}

std::span<const ExitCode> exit_codes() { return kExitCodes; }

std::vector<std::string> first_steps() {
  const std::string stack = input_word("IN", Contents::stack);
  const std::string model = output_word("OUT", Contents::model);
  return {"tetloft info " + stack, "tetloft reconstruct " + stack + " -o " + model,
          "tetloft render " + model + " -o OUT.html"};
}

std::string general_help() {
  std::string text = "usage: tetloft COMMAND …\n\n" + std::string(kSummary) + "\n\ncommands:\n";
  for (const Command& command : all_commands()) {
    std::string name = "  " + std::string(command.usage.command);
    name.resize(16, ' ');
    text += name + std::string(command.usage.summary) + '\n';
  }
  text +=
      "\n  --help        print this help; tetloft COMMAND --help tells more\n"
      "  --version     print the version\n\n"
      "first steps:\n";
  for (const std::string& step : first_steps()) text += "  " + step + '\n';
  text += '\n';
  append_wrapped(text, exit_code_sentence(), 0);
  return text;
}

}  // namespace tetloft::cli
