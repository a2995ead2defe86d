// The precision of values that are reported, ordered by and decided from.
#pragma once

#include <cmath>

namespace tetloft::internal::sections {

/// Far fewer bits than bounds in doubles hold, so that equal values come out equal whichever way
/// they were computed.
inline constexpr int kReportedBits = 32;

/// To kReportedBits significant bits, halves rounded up. Requires a finite value, not negative.
[[nodiscard]] inline double to_reported_bits(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::floor(std::ldexp(mantissa, kReportedBits) + 0.5),
                    exponent - kReportedBits);
}

}  // namespace tetloft::internal::sections
