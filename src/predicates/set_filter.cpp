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

// The power of two that divides a coordinate other than zero: its exponent.
int exponent_of_unit(double v) {
  const Decomposed d(v);
  return d.exponent + std::countr_zero(d.mantissa);
}

}  // namespace

SetFilter::SetFilter(std::span<const Point3> points)
    : SetFilter(points.size(), [&](std::size_t i) -> const Point3& { return points[i]; }) {}

void SetFilter::extend(const Point3& p) {
  take(p);
  set_bounds();
}

void SetFilter::take(const Point3& p) {
  low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
  high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  for (const double v : {p.x, p.y, p.z}) {
    if (v != 0) unit_ = std::min(unit_, exponent_of_unit(v));
  }
}

SetFilter SetFilter::with(const Point3& p) const {
  SetFilter result = *this;
  result.low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
  result.high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  result.unit_ = kNoUnit;
  result.set_bounds();
  return result;
}

void SetFilter::set_bounds() {
  exact_ = false;
  orient3d_bound_ = insphere_bound_ = HUGE_VAL;
  // Rounding is monotonic: no computed difference exceeds these.
  const double mx = high_.x - low_.x, my = high_.y - low_.y, mz = high_.z - low_.z;
  if (!(largest(mx, my, mz) <= kLargest)) return;
  orient3d_bound_ = kOrient3dError * mx * my * mz + kTiny;
  insphere_bound_ = kInsphereError * mx * my * mz * (mx * mx + my * my + mz * mz) + kTiny;
  if (unit_ < kLeastUnit) return;
  exact_ = largest(mx, my, mz) <= std::ldexp(kMostUnitsOfSet, unit_);
  if (exact_) orient3d_bound_ = insphere_bound_ = 0;
}

}  // namespace tetloft::internal::predicates
