// What the user decides about a stack: labels, and links joined or parted.
#pragma once

#include <tetloft/tetloft.hpp>

#include "cli/arguments.hpp"

namespace tetloft::cli {

/// Reads --labels into the options; leaves them where it was not given. Each line must name
/// contours of `stack`, and those about voids holes, where voids are not free: the error names the
/// file, section and contour.
[[nodiscard]] Result<void> read_label_option(const Arguments& arguments, const SectionStack& stack,
                                             CorrespondenceOptions& options);

}  // namespace tetloft::cli
