// How a model is checked: what check and report have in common.
#pragma once

#include <vector>

#include <tetloft/check.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// --motions, --strict, --model-format, --threads.
[[nodiscard]] std::vector<Option> check_option_list();

/// These, but for the format, and those of correspondence_options().
[[nodiscard]] Result<CheckOptions> check_options(const Arguments& arguments, Console& console);

}  // namespace tetloft::cli
