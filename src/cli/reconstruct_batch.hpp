// reconstruct FOLDER|LIST: a solid of each of many stacks, by the same options.
#pragma once

#include <vector>

#include "cli/arguments.hpp"
#include "cli/console.hpp"

namespace tetloft::cli {

/// The command where the operand names many stacks (names_many()); `options` are all that it takes.
/// Solids that the log knows as done are left as they are; of the others each appears whole, and
/// those that fail keep none from being made. The exit code is that of the first failure.
[[nodiscard]] Result<int> reconstruct_batch(const Arguments& arguments,
                                            const std::vector<Option>& options, Console& console);

}  // namespace tetloft::cli
