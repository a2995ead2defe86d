// tetloft completion: what shells complete, from the same tables as --help.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"
#include "cli/help.hpp"

namespace tetloft::cli {

namespace {

// Whether an option's value, by its word in the help, names a file.
bool names_a_file(const Option& option) {
  constexpr std::array<std::string_view, 5> kFileWords{"FILE", "IN", "OUT", "MODEL", "PLAN"};
  const std::string_view word = std::string_view(option.value).substr(0, option.value.find('.'));
  return std::find(kFileWords.begin(), kFileWords.end(), word) != kFileWords.end();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// The first clause of an option's help that is more than a value of it.
std::string in_short(const std::string& help) {
  std::size_t end = help.find_first_of(":;(");
  while (end != std::string::npos &&
         std::count(help.begin(), help.begin() + static_cast<std::ptrdiff_t>(end), ' ') < 3) {
    end = help.find_first_of(":;(", end + 1);
  }
  std::string text = help.substr(0, end);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// In single quotes, as shells read it.
std::string quoted(std::string_view text, std::string_view quote) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += quote;
    } else {
      result += c;
    }
  }
  return result + '\'';
}
std::string sh_quoted(std::string_view text) { return quoted(text, "'\\''"); }
std::string fish_quoted(std::string_view text) { return quoted(text, "\\'"); }

std::vector<std::string> spellings(const Option& option) {
  std::vector<std::string> names{option.name};
  if (!option.alias.empty()) names.push_back(option.alias);
  return names;
}

std::string command_names(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.emplace_back(command.usage.command);
  return joined(names);
}

// --- bash ---------------------------------------------------------------------------------------

std::string bash_case(std::string_view command, const Option& option) {
  std::string pattern;
  for (const std::string& name : spellings(option)) {
    pattern += (pattern.empty() ? "" : " | ") + std::string(command) + ':' + name;
  }
  std::string action = "return";
  if (!option.words.empty()) {
    action = "words=" + sh_quoted(joined(option.words));
  } else if (names_a_file(option)) {
    action = "files=1";
  }
  return "    " + pattern + ") " + action + " ;;\n";
}

std::string bash_completion(const std::vector<Command>& commands) {
  std::string values;
  std::string options;
  for (const Command& command : commands) {
    std::vector<std::string> names;
    for (const Option& option : command.usage.options) {
      for (const std::string& name : spellings(option)) names.push_back(name);
      if (!option.value.empty()) values += bash_case(command.usage.command, option);
    }
    options += "      " + std::string(command.usage.command) +
               ") words=" + sh_quoted(joined(names)) + " ;;\n";
    if (!command.usage.words.empty()) {
      values += "    " + std::string(command.usage.command) + ':' +
                std::string(command.usage.command) +
                ") words=" + sh_quoted(joined(command.usage.words)) + " ;;\n";
    }
  }
  values += "    help:help) words=" + sh_quoted(command_names(commands)) + " ;;\n";
  return "# bash completion for tetloft\n"
         "_tetloft() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  local words= files=\n"
         "  COMPREPLY=()\n"
         "  # --option=value comes as three words.\n"
         "  if [[ $current == = ]]; then\n"
         "    current=\n"
         "  elif [[ $previous == = ]]; then\n"
         "    previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  if ((COMP_CWORD == 1)); then\n"
         "    words=" +
         sh_quoted(command_names(commands) + " help --help --version") +
         "\n"
         "  else case \"${COMP_WORDS[1]}:$previous\" in\n" +
         values + "    *) if [[ $current == -* ]]; then case \"${COMP_WORDS[1]}\" in\n" + options +
         "      esac; else files=1; fi ;;\n"
         "  esac; fi\n"
         "  if [[ $files ]]; then\n"
         "    compopt -o filenames 2>/dev/null\n"
         "    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n"
         "  else\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
         "  fi\n"
         "}\n"
         "complete -F _tetloft tetloft\n";
}

// --- zsh ----------------------------------------------------------------------------------------

// A text within a specification of _arguments or _describe.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("[]:\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_option(const Option& option) {
  std::string value;
  if (!option.value.empty()) {
    value = ':' + zsh_text(option.value) + ':';
    if (!option.words.empty()) value += '(' + joined(option.words) + ')';
    if (names_a_file(option)) value += "_files";
  }
  std::string text;
  for (const std::string& name : spellings(option)) {
    std::string spec;
    if (!option.alias.empty()) spec.append("(").append(joined(spellings(option))).append(")");
    // Long options take "=" or the next word, short ones the next word.
    spec += name + (!value.empty() && name.rfind("--", 0) == 0 ? "=" : "");
    spec += '[' + zsh_text(in_short(option.help)) + ']' + value;
    text += "        " + sh_quoted(spec) + " \\\n";
  }
  return text;
}

std::string zsh_completion(const std::vector<Command>& commands) {
  std::string described;
  std::string cases;
  for (const Command& command : commands) {
    const std::string name(command.usage.command);
    described +=
        "    " + sh_quoted(name + ':' + zsh_text(std::string(command.usage.summary))) + '\n';
    cases += "    " + name + ")\n      _arguments -s -S \\\n";
    for (const Option& option : command.usage.options) cases += zsh_option(option);
    const std::string rest = command.usage.words.empty()
                                 ? "*:file:_files"
                                 : "1:word:(" + joined(command.usage.words) + ")";
    cases += "        " + sh_quoted(rest) + " ;;\n";
  }
  return "#compdef tetloft\n"
         "_tetloft() {\n"
         "  local -a commands\n"
         "  commands=(\n" +
         described +
         "  )\n"
         "  if ((CURRENT == 2)); then\n"
         "    _describe command commands\n"
         "    return\n"
         "  fi\n"
         "  shift words\n"
         "  ((CURRENT--))\n"
         "  case $words[1] in\n" +
         cases + "    help)\n      _arguments " +
         sh_quoted("1:command:(" + command_names(commands) + ")") + " ;;\n" +
         "  esac\n"
         "}\n"
         "# Read as a file of functions it completes at once; sourced, it says for what.\n"
         "if [[ $funcstack[1] == _tetloft ]]; then _tetloft \"$@\"; else compdef _tetloft tetloft; "
         "fi\n";
}

// --- fish ---------------------------------------------------------------------------------------

std::string fish_option(std::string_view command, const Option& option) {
  std::string line = "complete -c tetloft -n '__fish_seen_subcommand_from " + std::string(command) +
                     "' -l " + option.name.substr(2);
  if (!option.alias.empty()) line += " -s " + option.alias.substr(1);
  if (!option.words.empty()) {
    line += " -x -a " + fish_quoted(joined(option.words));
  } else if (names_a_file(option)) {
    line += " -r -F";
  } else if (!option.value.empty()) {
    line += " -x";
  }
  return line + " -d " + fish_quoted(in_short(option.help)) + '\n';
}

std::string fish_completion(const std::vector<Command>& commands) {
  std::string text =
      "# fish completion for tetloft\n"
      "complete -c tetloft -n __fish_use_subcommand -f\n"
      "complete -c tetloft -n __fish_use_subcommand -l help -s h -d 'print help'\n"
      "complete -c tetloft -n __fish_use_subcommand -l version -d 'print the version'\n";
  text += "complete -c tetloft -n '__fish_seen_subcommand_from help' -f -a " +
          fish_quoted(command_names(commands)) + '\n';
  for (const Command& command : commands) {
    const std::string name(command.usage.command);
    text += "complete -c tetloft -n __fish_use_subcommand -a " + name + " -d " +
            fish_quoted(command.usage.summary) + '\n';
    if (!command.usage.words.empty()) {
      text += "complete -c tetloft -n '__fish_seen_subcommand_from " + name + "' -f -a " +
              fish_quoted(joined(command.usage.words)) + '\n';
    }
    for (const Option& option : command.usage.options) text += fish_option(name, option);
  }
  return text;
}

struct Shell {
  std::string_view name;
  std::string (*completion)(const std::vector<Command>&);
};
constexpr std::array kShells{Shell{"bash", bash_completion}, Shell{"zsh", zsh_completion},
                             Shell{"fish", fish_completion}};

Result<int> run_completion(const Arguments& arguments, Console& console) {
  const auto chosen = arguments.chosen_operand();
  if (!chosen) return chosen.error();
  const Result<void> told = console.deliver(kShells[*chosen].completion(all_commands()));
  if (!told) return told.error();
  return 0;
}

}  // namespace

Command completion_command() {
  Usage usage{"completion",
              "What a shell completes, for bash, zsh or fish.",
              {"SHELL"},
              {kHelpOption},
              "Try it by: source <(tetloft completion bash); in fish: tetloft completion fish | "
              "source. An installed tetloft brings them along."};
  for (const Shell& shell : kShells) usage.words.emplace_back(shell.name);
  return {usage, run_completion};
}

}  // namespace tetloft::cli
