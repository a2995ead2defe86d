// The centre of the circle through three points as determinants, with numbers of any kind.
#pragma once

#include <array>

#include "arithmetic/rounded_sum.hpp"

namespace tetloft::internal::delaunay2_detail {

/// Determinants by Cramer's rule, rounded; the centre minus the first point is (x, y) over twice
/// `determinant`.
struct CircleMinors {
  double x = 0;
  double y = 0;
  double determinant = 0;
};

/// Of points with x and y, with numbers as difference(u, v) makes them: doubles, or exact sums.
template <class Point, class Difference>
[[nodiscard]] CircleMinors circle_minors(const std::array<Point, 3>& p,
                                         const Difference& difference) {
  const auto bx = difference(p[1].x, p[0].x);
  const auto by = difference(p[1].y, p[0].y);
  const auto cx = difference(p[2].x, p[0].x);
  const auto cy = difference(p[2].y, p[0].y);
  const auto b_squared = bx * bx + by * by;
  const auto c_squared = cx * cx + cy * cy;
  return {rounded_sum(b_squared * cy - c_squared * by),
          rounded_sum(c_squared * bx - b_squared * cx), rounded_sum(bx * cy - by * cx)};
}

}  // namespace tetloft::internal::delaunay2_detail
