// Distances compared in integers: with all coordinates in units of a common power of two,
//   dist ≤ k u   ⇔   ((b − a) × (p − a))² ≤ (k u)² |b − a|²,
// and both sides are integers.
#include "check/edge_distance.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "arithmetic/bounded_integer.hpp"

namespace tetloft::internal::checking {

namespace {

// The largest power of two that all values are multiples of by their exponents.
int common_unit(std::initializer_list<double> values) {
  int unit = 971;
  for (const double value : values) {
    if (value != 0) unit = std::min(unit, Decomposed(value).exponent);
  }
  return unit;
}

struct Scaled {
  double mantissa;
  int exponent;  // value = mantissa · 2^exponent
};

template <int Capacity>
Scaled rounded(const BoundedInteger<Capacity>& value) {
  double mantissa = 0;
  const int limbs = std::min(value.size(), 3);
  for (int i = value.size() - 1; i >= value.size() - limbs; --i) {
    mantissa = mantissa * 0x1p32 + static_cast<double>(value[i]);
  }
  return {mantissa, 32 * (value.size() - limbs)};
}

int ulp_exponent(const Point2& a, const Point2& b) {
  const double largest = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
  return std::max(std::ilogb(largest) - 52, -1074);
}

}  // namespace

double edge_ulp(const Point2& a, const Point2& b) { return std::ldexp(1.0, ulp_exponent(a, b)); }

EdgeDistance distance_from_edge(const Point2& a, const Point2& b, const Point2& p, double ulps) {
  const int ulp = ulp_exponent(a, b);
  const double bound = std::min(std::ldexp(ulps, ulp), std::numeric_limits<double>::max());
  const int unit = common_unit({a.x, a.y, b.x, b.y, p.x, p.y, bound});
  const auto big = [unit](double value) { return to_big_integer(value, unit); };
  const auto dx = big(b.x) - big(a.x);
  const auto dy = big(b.y) - big(a.y);
  const auto cross = dx * (big(p.y) - big(a.y)) - dy * (big(p.x) - big(a.x));
  const auto length2 = dx * dx + dy * dy;
  const auto limit = big(bound);

  EdgeDistance result;
  result.within = compare_magnitudes(cross * cross, limit * limit * length2) <= 0;
  // dist / ulp = |cross| / |b − a| · 2^unit / 2^ulp, with the exponent of |b − a|² made even.
  const Scaled c = rounded(cross);
  Scaled l = rounded(length2);
  if (l.exponent % 2 != 0) l = {2 * l.mantissa, l.exponent - 1};
  result.ulps =
      std::ldexp(c.mantissa / std::sqrt(l.mantissa), c.exponent - l.exponent / 2 + unit - ulp);
  return result;
}

bool advances(const Point2& a, const Point2& b, const Point2& p, const Point2& q) {
  const int unit = common_unit({a.x, a.y, b.x, b.y, p.x, p.y, q.x, q.y});
  const auto big = [unit](double value) { return to_big_integer(value, unit); };
  const auto along =
      (big(b.x) - big(a.x)) * (big(q.x) - big(p.x)) + (big(b.y) - big(a.y)) * (big(q.y) - big(p.y));
  return along.sign() > 0;
}

}  // namespace tetloft::internal::checking
