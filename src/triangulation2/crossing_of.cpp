#include "triangulation2/crossing_of.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "arithmetic/double_double.hpp"

namespace tetloft::internal::triangulation2 {

namespace {

DoubleDouble exact_difference(double a, double b) {
  const Rounded r = two_difference(a, b);
  return {r.value, r.error};
}

// (b − a) × (d − c).
DoubleDouble cross_of(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return exact_difference(b.x, a.x) * exact_difference(d.y, c.y) -
         exact_difference(b.y, a.y) * exact_difference(d.x, c.x);
}

// a + t (b − a), kept in the boxes of both segments, where the crossing is.
double between_both(double t, double a, double b, double c, double d) {
  const DoubleDouble along = DoubleDouble{t, 0} * exact_difference(b, a);
  const DoubleDouble sum = DoubleDouble{a, 0} + along;
  const double low = std::max(std::min(a, b), std::min(c, d));
  const double high = std::min(std::max(a, b), std::max(c, d));
  return std::clamp(sum.high, low, high);
}

// The distance of a coordinate's doubles.
double step_at(double v) { return std::nextafter(std::abs(v), HUGE_VAL) - std::abs(v); }

bool is_between(double x, double a, double b) { return std::min(a, b) <= x && x <= std::max(a, b); }

// Do the segment c d and its box hold e, as near as rounding may put a point of the segment? In
// each coordinate it is off by half a step at most; here by twice that.
bool nearly_holds(const Point2& c, const Point2& d, const Point2& e) {
  if (!is_between(e.x, c.x, d.x) || !is_between(e.y, c.y, d.y)) return false;
  const double pixel = std::abs(d.x - c.x) * step_at(e.y) + std::abs(d.y - c.y) * step_at(e.x);
  return std::abs(cross_of(c, d, c, e).high) < pixel;
}

}  // namespace

std::optional<Point2> crossing_of(Point2 a, Point2 b, Point2 c, Point2 d) {
  if (canonical_less(b, a)) std::swap(a, b);
  if (canonical_less(d, c)) std::swap(c, d);
  if (canonical_less(c, a) || (a == c && canonical_less(d, b))) {
    std::swap(a, c);
    std::swap(b, d);
  }
  for (const Point2& e : {a, b}) {
    if (nearly_holds(c, d, e)) return e;
  }
  for (const Point2& e : {c, d}) {
    if (nearly_holds(a, b, e)) return e;
  }
  const double t = cross_of(a, c, c, d).high / cross_of(a, b, c, d).high;
  const Point2 at{between_both(t, a.x, b.x, c.x, d.x), between_both(t, a.y, b.y, c.y, d.y)};
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  return at;
}

}  // namespace tetloft::internal::triangulation2
