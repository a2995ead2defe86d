// The overlap of two regions in integers, for what intervals cannot decide.
#pragma once

#include "arithmetic/big_integer.hpp"
#include "sections/trapezoids.hpp"

namespace tetloft::internal::sections {

/// Areas in one unit: the overlap is numerator / denominator, the smaller area `smaller`;
/// denominator and smaller are positive.
struct ExactOverlap {
  BigInteger numerator, denominator, smaller;
};

[[nodiscard]] ExactOverlap exact_overlap(const Trapezoids& a, const Trapezoids& b);

/// The sign of overlap / smaller − tau, for finite tau.
[[nodiscard]] Sign compare(const ExactOverlap& overlap, double tau);

/// overlap / smaller to `bits` significant bits (at most 52), halves rounded up. Requires
/// a positive overlap.
[[nodiscard]] double rounded_ratio(const ExactOverlap& overlap, int bits);

}  // namespace tetloft::internal::sections
