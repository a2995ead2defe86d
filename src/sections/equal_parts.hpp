// Points that divide an edge into equal parts.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::sections {

/// Appends a, and the points that divide the edge from a to b into so many parts: computed from its
/// lower end, so the same whichever way the contour runs. Parts below the spacing of doubles are
/// none.
inline void append_parts(const Point2& a, const Point2& b, std::size_t parts,
                         std::vector<Point2>& points) {
  const bool forward = canonical_less(a, b);
  const Point2& low = forward ? a : b;
  const Point2& high = forward ? b : a;
  points.push_back(a);
  for (std::size_t k = 1; k < parts; ++k) {
    const double t = static_cast<double>(forward ? k : parts - k) / static_cast<double>(parts);
    const Point2 p{low.x + t * (high.x - low.x), low.y + t * (high.y - low.y)};
    if (p != points.back() && p != b) points.push_back(p);
  }
}

}  // namespace tetloft::internal::sections
