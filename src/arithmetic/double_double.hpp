// Unevaluated sums of two doubles: twice the precision.
//
// Errors, with u = 2^-53, of values |low| <= u |high|:
// sum: the two low parts and the two roundings of low-order terms lose at most
//   u · 2 u (|a| + |b|) + u · 3 u (|a| + |b|) = 5 u² (|a| + |b|);
// product: the neglected low·low is at most u² |a b|, the roundings of terms of order u are at most
//   u² |a b| · (1 + 1 + 2 + 3), in all less than 10 u² |a b| with higher orders.
// Hence every operation has an error of at most 10 u² times its operands' sum or product of
// magnitudes.
#pragma once

#include "arithmetic/expansion.hpp"

namespace tetloft::internal {

struct DoubleDouble {
  double high = 0;
  double low = 0;
};

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

}  // namespace tetloft::internal
