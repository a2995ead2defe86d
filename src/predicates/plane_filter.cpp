// See plane_filter.hpp.
#include "predicates/plane_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "arithmetic/bounded_integer.hpp"

namespace tetloft::internal::predicates {

namespace {

// Differences of at most this many units: all intermediate values of the in-circle determinant
// are integers, and none exceeds the sum of its monomials' magnitudes, 12 · 5200⁴ < 2⁵³.
constexpr double kMostUnitsOfPlane = 5200;
// Products of four units must neither under- nor overflow.
constexpr int kLeastUnit = -200;
constexpr int kGreatestUnit = 150;

}  // namespace

PlaneFilter::PlaneFilter(std::span<const Point2> points) {
  if (points.empty()) return;
  Point2 low = points.front();
  Point2 high = low;
  int unit = kGreatestUnit + 1;  // the exponent of the power of two that divides all so far
  for (const Point2& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    for (const double v : {p.x, p.y}) {
      if (v == 0) continue;
      const Decomposed d(v);
      unit = std::min(unit, d.exponent + std::countr_zero(d.mantissa));
    }
    // Most sets that are no lattice show it within a few points.
    const double extent = std::max(high.x - low.x, high.y - low.y);
    if (unit < kLeastUnit || !(extent <= std::ldexp(kMostUnitsOfPlane, unit))) return;
  }
  if (unit > kGreatestUnit) return;
  exact_ = true;
  orient2d_bound_ = incircle_bound_ = {0, 0};
  per_unit_ = std::ldexp(1.0, -unit);
  low_ = low;
  high_ = high;
}

bool PlaneFilter::on_lattice(const Point2& p) const {
  if (p.x < low_.x || p.x > high_.x || p.y < low_.y || p.y > high_.y) return false;
  const double x = p.x * per_unit_;
  const double y = p.y * per_unit_;
  // A product that underflows has a rounded coordinate of less than a unit behind it.
  return std::floor(x) == x && std::floor(y) == y && (x != 0 || p.x == 0) && (y != 0 || p.y == 0);
}

}  // namespace tetloft::internal::predicates
