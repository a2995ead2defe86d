// Intervals that contain the exact result whatever rounding did: every bound is moved one
// double outwards. For boxes around constructed points, never for decisions.
// An oracle's: it shares nothing with arithmetic/interval.hpp, which the reconstruction uses.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetloft::internal::checking {

struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double value) : low(value), high(value) {}
  Interval(double l, double h) : low(l), high(h) {}

  static Interval everything() {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {-kInfinity, kInfinity};
  }
  /// [l, h], widened; everything if a bound is not a number.
  static Interval around(double l, double h) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (std::isnan(l) || std::isnan(h)) return everything();
    return {std::nextafter(l, -kInfinity), std::nextafter(h, kInfinity)};
  }
};

inline Interval operator+(const Interval& a, const Interval& b) {
  return Interval::around(a.low + b.low, a.high + b.high);
}

inline Interval operator-(const Interval& a, const Interval& b) {
  return Interval::around(a.low - b.high, a.high - b.low);
}

inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.low * b.low;
  const double q = a.low * b.high;
  const double r = a.high * b.low;
  const double s = a.high * b.high;
  // std::min would hide a NaN that is not its first argument; their sum does not.
  if (std::isnan(p + q + r + s)) return Interval::everything();
  return Interval::around(std::min({p, q, r, s}), std::max({p, q, r, s}));
}

inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.low <= 0 && b.high >= 0) return Interval::everything();
  const double p = a.low / b.low;
  const double q = a.low / b.high;
  const double r = a.high / b.low;
  const double s = a.high / b.high;
  if (std::isnan(p + q + r + s)) return Interval::everything();
  return Interval::around(std::min({p, q, r, s}), std::max({p, q, r, s}));
}

}  // namespace tetloft::internal::checking
