// tetloft reconstruct --plan PLAN --slabs A:B: a piece of a planned stack.
#pragma once

#include <string>

#include <tetloft/pieces.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

[[nodiscard]] Result<int> reconstruct_piece(const Arguments& arguments, Console& console);

/// What a piece, or a plan's stack, is read from: of a file all that tells it from others, of "-"
/// nothing.
[[nodiscard]] Result<PlanSource> source_of(const std::string& input);
/// Of a plan: 16 digits.
[[nodiscard]] std::string identity_text(std::uint64_t identity);

}  // namespace tetloft::cli
