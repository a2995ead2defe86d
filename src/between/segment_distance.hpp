// How far a point is from a segment, in doubles.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::between {

[[nodiscard]] inline double squared_distance(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  double t = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  t = t > 0 ? t : 0;
  t = t < 1 ? t : 1;
  const double ex = (p.x - a.x) - t * dx;
  const double ey = (p.y - a.y) - t * dy;
  return ex * ex + ey * ey;
}

}  // namespace tetloft::internal::between
