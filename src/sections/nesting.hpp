// The direction of a simple contour, which nesting, labels and overlap all need.
#pragma once

#include <tetloft/sections.hpp>

namespace tetloft::sections {

/// Does the contour run counter-clockwise? Requires a simple one; exact, linear.
[[nodiscard]] bool is_counter_clockwise(const Contour& contour);

}  // namespace tetloft::sections
