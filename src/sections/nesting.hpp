// The direction of a simple contour, which nesting, labels and overlap all need.
#pragma once

#include <tetloft/overlap.hpp>

namespace tetloft::internal::sections {

/// Does the contour run counter-clockwise? Requires a simple one; exact, linear.
[[nodiscard]] bool is_counter_clockwise(const Contour& contour);

/// What can be nested at all: contours of three finite vertices or more.
[[nodiscard]] bool has_contours(const Section& section);

}  // namespace tetloft::internal::sections
