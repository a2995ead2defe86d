// Intervals of doubles: the true value lies between lo and hi, whatever was rounded.
//
// Every bound is computed in round-to-nearest and moved outwards afterwards by more than
// half a unit in the last place; the rounding mode is never touched.
// Requires values far from overflow: callers scale by powers of two.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::internal {

/// A double not below any real that rounds to x. For 2^k ≤ |x| < 2^(k+1) the unit in the
/// last place is 2^(k−52) ≤ |x| 2^−52, the spacing towards zero at most that; the last
/// term covers the denormals. All products that could round are above it.
inline double upwards(double x) { return x + (std::abs(x) * 0x1p-52 + 0x1p-1074); }
inline double downwards(double x) { return x - (std::abs(x) * 0x1p-52 + 0x1p-1074); }

struct Interval {
  double lo = 0;
  double hi = 0;

  [[nodiscard]] bool positive() const { return lo > 0; }
  [[nodiscard]] bool negative() const { return hi < 0; }
};

/// a − b of two doubles.
inline Interval difference(double a, double b) {
  const double d = a - b;
  return {downwards(d), upwards(d)};
}

inline Interval operator+(const Interval& a, const Interval& b) {
  return {downwards(a.lo + b.lo), upwards(a.hi + b.hi)};
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return {downwards(a.lo - b.hi), upwards(a.hi - b.lo)};
}
inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }

inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = a.lo * b.lo;
  const double q = a.lo * b.hi;
  const double r = a.hi * b.lo;
  const double s = a.hi * b.hi;
  return {downwards(std::min(std::min(p, q), std::min(r, s))),
          upwards(std::max(std::max(p, q), std::max(r, s)))};
}

/// a / b. Requires b positive.
inline Interval quotient(const Interval& a, const Interval& b) {
  return {downwards(a.lo / (a.lo < 0 ? b.lo : b.hi)), upwards(a.hi / (a.hi < 0 ? b.hi : b.lo))};
}

inline Interval absolute(const Interval& a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return {0, std::max(-a.lo, a.hi)};
}

inline Interval minimum(const Interval& a, const Interval& b) {
  return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
}

/// A sum of many terms, added pairwise so that its width grows with the logarithm of
/// their number only.
class IntervalSum {
 public:
  void add(Interval term) {
    // partial_[k] is valid iff bit k of count_ is set, and then holds 2^k terms.
    std::uint64_t bits = count_++;
    int k = 0;
    for (; (bits & 1U) != 0; bits >>= 1, ++k) term = partial_[k] + term;
    partial_[k] = term;
  }
  [[nodiscard]] Interval total() const {
    Interval sum;
    for (int k = 0; k < 64; ++k) {
      if (((count_ >> k) & 1U) != 0) sum = sum + partial_[k];
    }
    return sum;
  }

 private:
  std::uint64_t count_ = 0;
  Interval partial_[64];
};

}  // namespace tetloft::internal
