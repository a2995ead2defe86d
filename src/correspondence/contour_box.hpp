// The bounding box of a contour.
#pragma once

#include <algorithm>

#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

struct ContourBox {
  Point2 low, high;
  [[nodiscard]] bool meets(const ContourBox& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
};

/// Requires a vertex.
[[nodiscard]] inline ContourBox box_of(const Contour& contour) {
  ContourBox box{contour.vertices.front(), contour.vertices.front()};
  for (const Point2& p : contour.vertices) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

}  // namespace tetloft::internal
