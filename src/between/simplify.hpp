// Fewer vertices for the contours of a section: Douglas and Peucker (Cartographica 10, 1973), with
// the areas kept, and no contour brought to touch another.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::between {

struct SimplifiedSection {
  Section section;  ///< valid, unless it has no contours
  Nesting nesting;
};

/// The same contours with fewer vertices: each within about `tolerance`, in units of the section,
/// of where it was, around the same area up to terms of second order. Contours and their nesting
/// stay; where they would not, the contours come as near to what they were as it takes. None if the
/// section is invalid as it is. A function of the contours, each as it starts and runs.
[[nodiscard]] std::optional<SimplifiedSection> simplify(const Section& section, double tolerance,
                                                        double longest);

}  // namespace tetloft::internal::between
