#include "delaunay2/diametral.hpp"

#include <algorithm>
#include <cmath>

#include "arithmetic/bounded_integer.hpp"
#include "predicates/filter.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// All coordinates as integers, in units of the lowest bit that any of them has.
Sign exact_angle_sign(const Point2& a, const Point2& v, const Point2& b) {
  int unit = 971;  // that of the largest double
  for (const double coordinate : {a.x, a.y, b.x, b.y, v.x, v.y}) {
    if (coordinate != 0) unit = std::min(unit, Decomposed(coordinate).exponent);
  }
  const auto difference = [unit](double p, double q) {
    return to_big_integer(p, unit) - to_big_integer(q, unit);
  };
  const auto x = difference(a.x, v.x) * difference(b.x, v.x);
  const auto y = difference(a.y, v.y) * difference(b.y, v.y);
  return static_cast<Sign>((x + y).sign());
}

}  // namespace

Sign angle_sign(const Point2& a, const Point2& v, const Point2& b) {
  // A sum of two products of differences, as orient2d is a difference of such: its error
  // bound holds, and products that overflow make the bound infinite or not a number.
  const double x = (a.x - v.x) * (b.x - v.x);
  const double y = (a.y - v.y) * (b.y - v.y);
  const double bound =
      predicates::kOrient2dError * (std::abs(x) + std::abs(y)) + predicates::kOrient2dTiny;
  const int sign = predicates::certain_sign(x + y, bound);
  return sign != 0 ? static_cast<Sign>(sign) : exact_angle_sign(a, v, b);
}

}  // namespace tetloft::internal::delaunay2_detail
