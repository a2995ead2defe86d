// What shells complete, and the manual page: all that --help tells, and nothing that it does not.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/runner.hpp"

namespace tetloft {
namespace {

using test::expect_failure;
using test::Outcome;
using test::run;

// The commands that the general help lists.
std::vector<std::string> commands_told() {
  std::istringstream help(run({"--help"}).out);
  std::vector<std::string> names;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (line == "commands:") {
      listed = true;
    } else if (listed && line.empty()) {
      break;
    } else if (listed) {
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return names;
}

// The long options in the left column of a command's help.
std::set<std::string> options_told(const std::string& command) {
  std::istringstream help(run({command, "--help"}).out);
  std::set<std::string> names;
  for (std::string line; std::getline(help, line);) {
    if (line.rfind("  -", 0) != 0) continue;
    const std::size_t at = line.find("--");
    names.insert(line.substr(at, line.find(' ', at) - at));
  }
  return names;
}

// The words that follow `before` in a text, as far as letters and "-" go.
std::set<std::string> words_after(const std::string& text, const std::string& before) {
  std::set<std::string> words;
  for (std::size_t at = text.find(before); at != std::string::npos;
       at = text.find(before, at + 1)) {
    const std::size_t from = at + before.size();
    const std::size_t to = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", from);
    words.insert(text.substr(from, to - from));
  }
  return words;
}

// From the line of a text that holds `mark` to the one that holds `end`.
std::string part_of(const std::string& text, const std::string& mark, const std::string& end) {
  const std::size_t from = text.find(mark);
  EXPECT_NE(from, std::string::npos) << mark;
  if (from == std::string::npos) return {};
  return text.substr(from, text.find(end, from + mark.size()) - from);
}

TEST(Completion, OfBashKnowsAllCommandsAndOptions) {
  const std::string script = run({"completion", "bash"}).out;
  for (const std::string& command : commands_told()) {
    const std::string options = part_of(script, "      " + command + ") words=", ";;");
    for (const std::string& option : options_told(command)) {
      EXPECT_NE((options + ' ').find(option), std::string::npos) << command << ' ' << option;
    }
  }
  EXPECT_NE(script.find("reconstruct:--ends) words='flat half'"), std::string::npos);
  EXPECT_NE(script.find("reconstruct:--output | reconstruct:-o) files=1"), std::string::npos);
  EXPECT_NE(script.find("plan:--output | plan:-o) files=1"), std::string::npos);
  EXPECT_NE(script.find("join:--plan) files=1"), std::string::npos);
}

TEST(Completion, OfZshKnowsAllCommandsAndOptions) {
  const std::string script = run({"completion", "zsh"}).out;
  for (const std::string& command : commands_told()) {
    const std::string options = part_of(script, "    " + command + ")\n", ";;");
    for (const std::string& option : options_told(command)) {
      const bool told = options.find(option + '[') != std::string::npos ||
                        options.find(option + "=[") != std::string::npos;
      EXPECT_TRUE(told) << command << ' ' << option;
    }
  }
  EXPECT_NE(script.find(":HOW:(flat half)'"), std::string::npos);
}

TEST(Completion, OfFishKnowsAllCommandsAndOptions) {
  const std::string script = run({"completion", "fish"}).out;
  for (const std::string& command : commands_told()) {
    std::set<std::string> long_names;
    for (const std::string& name :
         words_after(script, "'__fish_seen_subcommand_from " + command + "' -l ")) {
      long_names.insert("--" + name);
    }
    EXPECT_EQ(long_names, options_told(command)) << command;
  }
}

TEST(Manual, TellsAllCommandsAndOptions) {
  const Outcome outcome = run({"manual"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out.rfind(".TH TETLOFT 1", 0), 0U);
  std::string text = outcome.out;
  for (std::size_t at; (at = text.find("\\-")) != std::string::npos;) text.erase(at, 1);
  for (const std::string& command : commands_told()) {
    const std::string section = part_of(text, ".SS tetloft " + command, "\n.S");
    for (const std::string& option : options_told(command)) {
      EXPECT_NE(section.find("\\fB" + option + "\\fR"), std::string::npos) << command << option;
    }
  }
  for (const char* code : {"0", "1", "2", "3", "4", "5", "7", "70", "71", "72"}) {
    EXPECT_NE(text.find(".TP\n\\fB" + std::string(code) + "\\fR\n"), std::string::npos) << code;
  }
}

TEST(Completion, RefusesShellsThatItDoesNotKnow) {
  expect_failure({"completion"}, 2, "usage", "SHELL");
  expect_failure({"completion", "fsh"}, 2, "usage", "fish");
  expect_failure({"completion", "bash", "zsh"}, 2, "usage", "zsh");
  expect_failure({"manual", "bash"}, 2, "usage", "bash");
}

}  // namespace
}  // namespace tetloft
