// Distances in the plane, in doubles: for what is decided against a stated length.
#pragma once

#include <algorithm>

#include <tetloft/point.hpp>

namespace tetloft::internal::sections {

[[nodiscard]] inline double square_distance(const Point2& p, const Point2& q) {
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  return x * x + y * y;
}

/// The point of the segment a b that is nearest to p; an end, exactly, where that is.
[[nodiscard]] inline Point2 nearest_on(const Point2& p, const Point2& a, const Point2& b) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double along = (p.x - a.x) * x + (p.y - a.y) * y;
  const double all = x * x + y * y;
  if (!(along > 0)) return a;
  if (along >= all) return b;
  return {a.x + along / all * x, a.y + along / all * y};
}

[[nodiscard]] inline double square_distance(const Point2& p, const Point2& a, const Point2& b) {
  return square_distance(p, nearest_on(p, a, b));
}

}  // namespace tetloft::internal::sections
