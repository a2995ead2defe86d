// The lattice stage: determinants of small multiples of one power of two, in plain integers.
//
// Points of pixel grids are cocircular by the thousand, and no floating-point filter can
// answer zero. Their differences, however, are doubles with few significant bits: divided by
// a common power of two they are integers so small that 64 bits hold the determinant.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tetloft::internal::predicates {

/// Integers of magnitude below 2^bits that have the ratios of `differences`, if such exist
/// with the unit 2^-bits of the power of two above the largest difference.
template <int bits, std::size_t n>
std::optional<std::array<std::int64_t, n>> to_lattice(const std::array<double, n>& differences) {
  double largest = 0;
  for (const double d : differences) largest = std::max(largest, std::abs(d));
  // The biased exponent b stands for 2^(b − 1023) <= largest < 2^(b − 1022).
  const std::uint64_t biased = std::bit_cast<std::uint64_t>(largest) >> 52;
  // Where largest is zero, or nearly denormal, or infinite, the unit or its inverse would
  // not be a normal double.
  if (biased < bits || biased > 2046) return std::nullopt;
  const double unit = std::bit_cast<double>((biased + 1 - bits) << 52);
  const double inverse = std::bit_cast<double>((2046 - (biased + 1 - bits)) << 52);
  std::array<std::int64_t, n> result;
  for (std::size_t i = 0; i < n; ++i) {
    result[i] = static_cast<std::int64_t>(differences[i] * inverse);
    // Exact: fewer than 53 bits times a power of two, not below the normal range. Where it fails it
    // mostly does at once.
    if (static_cast<double>(result[i]) * unit != differences[i]) return std::nullopt;
  }
  return result;
}

}  // namespace tetloft::internal::predicates
