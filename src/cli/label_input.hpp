// What the user decides about a stack: labels, and links joined or parted.
#pragma once

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"
#include "cli/stack_input.hpp"

namespace tetloft::cli {

/// Reads --labels into the options; where it was not given the labels are those that came with the
/// stack. Each line must name contours of the stack, and those about voids holes, where voids are
/// not free: the error names the file, section and contour.
[[nodiscard]] Result<void> read_label_option(const Arguments& arguments, const StackInput& input,
                                             CorrespondenceOptions& options);

}  // namespace tetloft::cli
