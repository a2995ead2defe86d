// Unevaluated sums of two doubles: a filter of twice the precision, for points that are nearly
// cospherical but not exactly so, as points on a sphere are after rounding.
//
// Errors, with u = 2^-53, of values |low| <= u |high|:
// sum: the two low parts and the two roundings of low-order terms lose at most
//   u · 2 u (|a| + |b|) + u · 3 u (|a| + |b|) = 5 u² (|a| + |b|);
// product: the neglected low·low is at most u² |a b|, the roundings of terms of order u are at most
//   u² |a b| · (1 + 1 + 2 + 3), in all less than 10 u² |a b| with higher orders.
// product with a double, and of two doubles: terms are missing, or all; the latter is exact.
// Hence every operation has an error of at most 10 u² times its operands' sum or product of
// magnitudes, and the bounds of filter.hpp hold with 10 u² for u. Underflow is as there.
#pragma once

#include "arithmetic/expansion.hpp"

namespace tetloft::internal {

struct DoubleDouble {
  double high = 0;
  double low = 0;
};

inline constexpr double kDoubleDoubleRounding = 10 * 0x1p-106;

inline DoubleDouble normalised(const Rounded& sum, double low) {
  const Rounded r = two_sum(sum.value, sum.error + low);
  return {r.value, r.error};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  return normalised(two_sum(a.high, b.high), a.low + b.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return normalised(two_difference(a.high, b.high), a.low - b.low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  return normalised(two_product(Halves(a.high), Halves(b.high)), a.high * b.low + a.low * b.high);
}

/// Of doubles that are factors many times, and so are cut in halves once.
inline DoubleDouble operator*(const Halves& a, const Halves& b) {
  const Rounded product = two_product(a, b);
  return {product.value, product.error};
}

inline DoubleDouble operator*(const Halves& a, const DoubleDouble& b) {
  return normalised(two_product(a, Halves(b.high)), a.whole * b.low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const Halves& b) { return b * a; }

}  // namespace tetloft::internal
