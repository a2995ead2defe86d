// The circumcentre: the only construction whose result is never input to anything.
#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/delaunay2.hpp>

#include "delaunay2/circle_minors.hpp"

namespace tetloft {

using namespace internal;

// Relative to the lowest vertex, so that the order of arguments does not matter, and with
// exact determinants, so that slivers lose no more than three roundings. A power of two
// brings coordinates below 1, where nothing overflows; what underflows then is below
// 2^-1000 of the largest coordinate.
Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
  std::array<Point2, 3> p{a, b, c};
  std::sort(p.begin(), p.end(),
            [](const Point2& u, const Point2& v) { return canonical_less(u, v); });
  double largest = 0;
  for (const Point2& q : p) largest = std::max({largest, std::abs(q.x), std::abs(q.y)});
  const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  for (Point2& q : p) q = {std::ldexp(q.x, -exponent), std::ldexp(q.y, -exponent)};

  const auto difference = [](double u, double v) { return to_expansion(two_difference(u, v)); };
  const delaunay2_detail::CircleMinors minors = delaunay2_detail::circle_minors(p, difference);
  const double x = minors.x / (2 * minors.determinant);
  const double y = minors.y / (2 * minors.determinant);
  return {std::ldexp(p[0].x + x, exponent), std::ldexp(p[0].y + y, exponent)};
}

}  // namespace tetloft
