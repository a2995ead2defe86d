#include "delaunay2/shells.hpp"

#include <algorithm>
#include <cmath>

namespace tetloft::internal::delaunay2_detail {

namespace {

/// A sum that is a denormal after halving was exact before; a sum that overflows has terms
/// that are exact after halving. So one rounding in every case.
double middle(double a, double b) {
  const double sum = a + b;
  return std::isfinite(sum) ? 0.5 * sum : 0.5 * a + 0.5 * b;
}

}  // namespace

Point2 midpoint(const Point2& a, const Point2& b) { return {middle(a.x, b.x), middle(a.y, b.y)}; }

double roundest_between(double a, double b) {
  const double third = (std::max(a, b) - std::min(a, b)) / 3;
  const double low = std::min(a, b) + third;
  const double high = std::max(a, b) - third;
  if (!(low <= high) || !(high > 0)) return middle(a, b);  // no room, as lies_between() finds
  // Ends at the last bit of `high` at the latest, where the multiple is `high` itself.
  double unit = std::ldexp(1.0, std::ilogb(high));
  double multiple = unit;
  while (multiple < low) {
    unit /= 2;
    multiple = std::floor(high / unit) * unit;
  }
  return multiple;
}

bool lies_between(const Point2& a, const Point2& c, const Point2& b) {
  const auto [low_x, high_x] = std::minmax(a.x, b.x);
  const auto [low_y, high_y] = std::minmax(a.y, b.y);
  if (c.x < low_x || c.x > high_x || c.y < low_y || c.y > high_y) return false;
  return (low_x < c.x && c.x < high_x) || (low_y < c.y && c.y < high_y);
}

Ray::Ray(const Point2& corner, const Point2& far)
    : corner_(corner), direction_{far.x - corner.x, far.y - corner.y} {
  const int exponent = std::ilogb(std::max(std::abs(direction_.x), std::abs(direction_.y)));
  const double x = std::ldexp(direction_.x, -exponent);
  const double y = std::ldexp(direction_.y, -exponent);
  length_ = std::sqrt(x * x + y * y);
}

Point2 Ray::at(double radius) const {
  const double fraction = radius / length_;
  return {corner_.x + fraction * direction_.x, corner_.y + fraction * direction_.y};
}

}  // namespace tetloft::internal::delaunay2_detail
