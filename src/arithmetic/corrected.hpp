// Doubles with the error of their computation to first order: a filter of twice the precision, for
// points that are nearly cospherical but not exactly so, as points on a sphere are after rounding.
//
// The values are what plain doubles give, as errors are not carried over into them. Let X be the
// sum of the magnitudes of a value's monomials, k the most roundings on the way to one of them, as
// in predicates/filter.hpp: the value's error is below k u X + O(u²), u = 2^-53, and so is the
// correction. The correction itself is off by β u² X at most, but for terms of third order, with
// sum:     β = max(βa, βb) + 2 k + 1 for k = max(ka, kb): the roundings of ca + cb and of adding
// the
//          sum's own error, which is known exactly;
// product: β = βa + βb + ka kb + 3 (ka + kb) + 1: the corrections' errors, the neglected ca cb, and
//          the roundings of two products and two sums.
// A difference of doubles has k = 1 and β = 0, so a product of two has (3, 8), a 2 × 2 minor (4,
// 15), a lift (5, 24), a 3 × 3 minor (8, 63), an in-sphere determinant (16, 227).
#pragma once

#include "arithmetic/expansion.hpp"

namespace tetloft::internal {

struct Corrected {
  double value;
  double correction;
};

inline constexpr double kOrient3dSecondOrder = 63;
inline constexpr double kInsphereSecondOrder = 227;

inline Corrected operator+(const Corrected& a, const Corrected& b) {
  const Rounded sum = two_sum(a.value, b.value);
  return {sum.value, (a.correction + b.correction) + sum.error};
}

inline Corrected operator-(const Corrected& a, const Corrected& b) {
  const Rounded difference = two_difference(a.value, b.value);
  return {difference.value, (a.correction - b.correction) + difference.error};
}

inline Corrected operator*(const Corrected& a, const Corrected& b) {
  const Rounded product = two_product(Halves(a.value), Halves(b.value));
  return {product.value, (a.value * b.correction + a.correction * b.value) + product.error};
}

/// Of doubles that are factors many times, and so are cut in halves once.
inline Corrected operator*(const Halves& a, const Halves& b) {
  const Rounded product = two_product(a, b);
  return {product.value, product.error};
}

inline Corrected operator*(const Halves& a, const Corrected& b) {
  const Rounded product = two_product(a, Halves(b.value));
  return {product.value, a.whole * b.correction + product.error};
}

inline Corrected operator*(const Corrected& a, const Halves& b) { return b * a; }

}  // namespace tetloft::internal
