// tetloft manual: the manual page, from the same tables as --help.
#include <string>
#include <string_view>

#include <tetloft/version.hpp>

#include "cli/commands.hpp"
#include "cli/help.hpp"

namespace tetloft::cli {

namespace {

// A text that roff shows as it is.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool first = result.empty() || result.back() == '\n';
    if (first && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + roff(text) + "\\fR"; }

std::string described(const Option& option) {
  std::string names = option.alias.empty() ? "" : bold(option.alias) + ", ";
  names += bold(option.name);
  if (!option.value.empty()) names += ' ' + italic(option.value);
  return ".TP\n" + names + '\n' + roff(option.help) + '\n';
}

std::string described(const Usage& usage) {
  std::string text = ".SS tetloft " + roff(usage.command) + roff(usage.operand_line()) +
                     " [options]\n" + roff(usage.summary) + '\n';
  for (const Option& option : usage.options) text += described(option);
  if (!usage.notes.empty()) text += ".PP\n" + roff(usage.notes) + '\n';
  return text;
}

std::string manual() {
  std::string text = ".TH TETLOFT 1 \"\" \"tetloft " + std::string(version()) +
                     "\" \"User Commands\"\n"
                     ".SH NAME\n"
                     "tetloft \\- solids from planar cross sections\n"
                     ".SH SYNOPSIS\n" +
                     bold("tetloft") + ' ' + italic("COMMAND") + " ...\n.br\n" + bold("tetloft") +
                     ' ' + italic("COMMAND") + ' ' + bold("--help") +
                     "\n"
                     ".SH DESCRIPTION\n"
                     "A stack of closed contours on parallel planes goes in; a tetrahedral mesh "
                     "and its boundary surface come out.\n"
                     ".SH COMMANDS\n";
  for (const Command& command : all_commands()) text += described(command.usage);
  text += ".SH EXIT STATUS\n";
  for (const ExitCode& exit : exit_codes()) {
    text += ".TP\n" + bold(std::to_string(exit.code)) + '\n' + roff(exit.meaning) + '\n';
  }
  text += ".SH EXAMPLES\n.nf\n";
  for (const std::string& step : first_steps()) text += roff(step) + '\n';
  return text + ".fi\n";
}

Result<int> run_manual(const Arguments&, Console& console) {
  const Result<void> told = console.deliver(manual());
  if (!told) return told.error();
  return 0;
}

}  // namespace

Command manual_command() {
  return {{"manual",
           "The manual page, for man.",
           {},
           {kHelpOption},
           "Read it by: tetloft manual | man -l -. An installed tetloft brings it along."},
          run_manual};
}

}  // namespace tetloft::cli
