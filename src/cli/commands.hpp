// The commands. Each has its usage and a function that returns the exit code, or the error
// that stopped it.
#pragma once

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

struct Command {
  Usage usage;
  Result<int> (*run)(const Arguments& arguments, Console& console);
};

[[nodiscard]] Command reconstruct_command();
[[nodiscard]] Command plan_command();
[[nodiscard]] Command join_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command delaunay_command();
[[nodiscard]] Command info_command();
[[nodiscard]] Command convert_command();
[[nodiscard]] Command slice_command();
[[nodiscard]] Command links_command();
[[nodiscard]] Command between_command();
[[nodiscard]] Command skeleton_command();
[[nodiscard]] Command render_command();
[[nodiscard]] Command report_command();
[[nodiscard]] Command completion_command();
[[nodiscard]] Command manual_command();

/// Exit code of `check` and `report` where a guarantee fails.
inline constexpr int kGuaranteeFails = 1;

/// Options that every command has.
inline const Option kJsonOption{"--json", "", "print exactly one JSON object on standard output"};
inline const Option kQuietOption{"--quiet", "",
                                 "no progress and no summary; warnings, errors and --json "
                                 "stay"};
inline const Option kHelpOption{"--help", "", "print this help", "-h"};

}  // namespace tetloft::cli
