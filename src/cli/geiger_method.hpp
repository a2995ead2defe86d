// --method geiger of tetloft reconstruct.
#pragma once

#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// Runs the command by Geiger's algorithm. Options that it has no use for are usage errors.
/// --verify tells, as warnings, what guarantees the model breaks: it promises none.
[[nodiscard]] Result<int> reconstruct_by_geiger(const Arguments& arguments, Console& console);

}  // namespace tetloft::cli
