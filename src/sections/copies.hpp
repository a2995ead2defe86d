// Contours that repeat another of their section, exactly or but for rounding.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

struct Copy {
  ContourId contour;
  ContourId kept;
  double apart = 0;  ///< how far at most a vertex of one lies from the other
};

/// The copies among contours of which these pairs touch, by contour, as repair() defines them
/// (tetloft/repair.hpp). Of exact copies the first is kept. What is decided from the contours'
/// numbers alone else does not depend on where they begin, their direction or their order.
[[nodiscard]] std::vector<Copy> find_copies(
    const Section& section, const std::vector<std::pair<ContourId, ContourId>>& touching);

}  // namespace tetloft::internal::sections
