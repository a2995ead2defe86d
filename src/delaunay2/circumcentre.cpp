// The circumcentre: the only construction whose result is never input to anything.
#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/delaunay2.hpp>

#include "arithmetic/expansion.hpp"

namespace tetloft {

using namespace internal;

namespace {

/// Components summed from the smallest: within two ulps of the exact value.
template <int Capacity>
double estimate(const Expansion<Capacity>& e) {
  double sum = 0;
  for (int i = 0; i < e.size(); ++i) sum += e[i];
  return sum;
}

}  // namespace

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
  const auto bx = difference(p[1].x, p[0].x);
  const auto by = difference(p[1].y, p[0].y);
  const auto cx = difference(p[2].x, p[0].x);
  const auto cy = difference(p[2].y, p[0].y);
  const auto b_squared = bx * bx + by * by;
  const auto c_squared = cx * cx + cy * cy;
  const double twice_determinant = 2 * estimate(bx * cy - by * cx);
  const double x = estimate(b_squared * cy - c_squared * by) / twice_determinant;
  const double y = estimate(c_squared * bx - b_squared * cx) / twice_determinant;
  return {std::ldexp(p[0].x + x, exponent), std::ldexp(p[0].y + y, exponent)};
}

}  // namespace tetloft
