// tetloft reconstruct --plan PLAN --slabs A:B: a piece of a planned stack.
#pragma once

#include <string>
#include <vector>

#include <tetloft/pieces.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// `known` are all options of the command: usage error where one is given that no piece takes.
[[nodiscard]] Result<int> reconstruct_piece(const Arguments& arguments,
                                            const std::vector<Option>& known, Console& console);

/// What a plan's stack was read from: of a file all that tells it from others, of "-" and other
/// streams nothing.
[[nodiscard]] Result<PlanSource> source_of(const std::string& input);

}  // namespace tetloft::cli
