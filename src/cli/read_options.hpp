// How a stack is read from its file: what of it, and as what.
#pragma once

#include <string>
#include <vector>

#include <tetloft/formats.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// --format, --roi, --label, --iso, --contours, --axis, --property, --plane-tolerance,
/// --close-on-frame.
[[nodiscard]] std::vector<Option> read_option_list();
/// As they were given. Usage errors for values that make no sense.
[[nodiscard]] Result<ReadOptions> read_options(const Arguments& arguments);

/// The file that an operand names: "-" is standard input.
[[nodiscard]] std::string input_path(const std::string& operand);

/// What --roi or --label says for every structure of a file.
inline constexpr const char* kAllStructures = "all";

}  // namespace tetloft::cli
