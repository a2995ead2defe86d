// --repaired: the stack as it is worked on, written beside a command's other outputs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "cli/arguments.hpp"
#include "cli/console.hpp"
#include "cli/outputs.hpp"

namespace tetloft::cli {

[[nodiscard]] Option repaired_option();

/// The file that was given, checked; it may be none of `taken`.
[[nodiscard]] Result<std::optional<std::string>> repaired_output(
    const Arguments& arguments, const std::vector<std::string>& taken);

/// Adds the stack to the files staged, where there is a path.
[[nodiscard]] Result<void> stage_repaired(const std::optional<std::string>& path,
                                          const SectionStack& stack, StagedFiles& files,
                                          Console& console);

}  // namespace tetloft::cli
