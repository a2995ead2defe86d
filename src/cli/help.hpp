// What --help says of the whole command line.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"

namespace tetloft::cli {

/// All commands, in the order of the help.
[[nodiscard]] std::vector<Command> all_commands();

struct ExitCode {
  int code;
  std::string_view meaning;
};
[[nodiscard]] std::span<const ExitCode> exit_codes();

/// The command lines that one begins with.
[[nodiscard]] std::vector<std::string> first_steps();

inline constexpr std::string_view kSummary = "Solids from planar cross sections.";

/// `tetloft --help`.
[[nodiscard]] std::string general_help();

}  // namespace tetloft::cli
