// See set_filter.hpp.
#include "predicates/set_filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "arithmetic/bounded_integer.hpp"

namespace tetloft::internal::predicates {

namespace {

// Differences of at most this many units: all intermediate values of the in-sphere determinant
// are integers, and none exceeds the sum of its monomials' magnitudes, 72 · 600⁵ < 2⁵³.
constexpr double kMostUnitsOfSet = 600;

// The power of two 2^unit that divides all coordinates: its exponent.
int common_exponent(std::span<const Point3> points) {
  int least = 971;
  for (const Point3& p : points) {
    for (const double v : {p.x, p.y, p.z}) {
      if (v == 0) continue;
      const Decomposed d(v);
      least = std::min(least, d.exponent + std::countr_zero(d.mantissa));
    }
  }
  return least;
}

}  // namespace

SetFilter::SetFilter(std::span<const Point3> points)
    : orient3d_bound_(HUGE_VAL), insphere_bound_(HUGE_VAL) {
  if (points.empty()) return;
  Point3 low = points.front();
  Point3 high = low;
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  // Rounding is monotonic: no computed difference exceeds these.
  const double mx = high.x - low.x, my = high.y - low.y, mz = high.z - low.z;
  if (!(largest(mx, my, mz) <= kLargest)) return;
  orient3d_bound_ = kOrient3dError * mx * my * mz + kTiny;
  insphere_bound_ = kInsphereError * mx * my * mz * (mx * mx + my * my + mz * mz) + kTiny;
  // Products of five units must neither under- nor overflow.
  const int unit = common_exponent(points);
  if (unit < -200 || unit > 150) return;
  exact_ = largest(mx, my, mz) <= std::ldexp(kMostUnitsOfSet, unit);
  if (exact_) orient3d_bound_ = insphere_bound_ = 0;
}

}  // namespace tetloft::internal::predicates
