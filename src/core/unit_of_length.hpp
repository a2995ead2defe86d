// A unit of length for heuristics: they square coordinates and multiply several, which over- or
// underflows far from 1. What is computed in this unit is the same at every scale, bit for bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <tetloft/point.hpp>

namespace tetloft::internal {

/// std::ldexp, in one multiplication where the power is a double.
inline double scaled(double value, int exponent) {
  if (exponent < -1022 || exponent > 1023) return std::ldexp(value, exponent);
  return value * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}
inline Point2 scaled(const Point2& p, int exponent) {
  return {scaled(p.x, exponent), scaled(p.y, exponent)};
}
inline Point3 scaled(const Point3& p, int exponent) {
  return {scaled(p.x, exponent), scaled(p.y, exponent), scaled(p.z, exponent)};
}

/// Is the number so multiplied by 2^exponent that multiplying back gives it again?
inline bool is_scaled_exactly(double value, int exponent) {
  return scaled(scaled(value, exponent), -exponent) == value;
}
inline bool is_scaled_exactly(const Point2& p, int exponent) {
  return is_scaled_exactly(p.x, exponent) && is_scaled_exactly(p.y, exponent);
}
inline bool is_scaled_exactly(const Point3& p, int exponent) {
  return is_scaled_exactly(p.x, exponent) && is_scaled_exactly(p.y, exponent) &&
         is_scaled_exactly(p.z, exponent);
}

/// The unit of the numbers put in; zeros and what is not finite do not count.
class UnitOfLength {
 public:
  void include(double value) {
    if (value == 0 || !std::isfinite(value)) return;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int field = static_cast<int>(bits >> 52 & 0x7FF);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t digits = field == 0 ? fraction : fraction | std::uint64_t{1} << 52;
    largest_ = std::max(largest_, std::abs(value));
    last_bit_ = std::min(last_bit_, std::max(field, 1) - 1075 + std::countr_zero(digits));
  }
  void include(const Point2& p) {
    include(p.x);
    include(p.y);
  }
  void include(const Point3& p) {
    include(p.x);
    include(p.y);
    include(p.z);
  }

  /// (1) Times 2^exponent() every number keeps all its bits, with room for finer ones between them.
  /// (2) The largest magnitude is then in [1, 2), or as near above as (1) allows. (3) Numbers times
  /// 2^k have exponent() − k: in their unit they are the same. Requires magnitudes below 2^1000.
  [[nodiscard]] int exponent() const {
    if (largest_ == 0) return 0;
    const int to_one = largest_to_one();
    return std::min(std::max(to_one, kLastBit + kRoom - last_bit_), kTop + to_one);
  }

  /// For figures: times 2^largest_to_one() the largest magnitude is in [1, 2); the smallest may
  /// lose bits.
  [[nodiscard]] int largest_to_one() const { return largest_ == 0 ? 0 : -std::ilogb(largest_); }

 private:
  static constexpr int kLastBit = -1074;  // of doubles
  static constexpr int kRoom = 64;        // binary digits of a construction, and some more
  static constexpr int kTop = 999;        // last_bit_ ≥ kLastBit allows it to any number

  double largest_ = 0;
  int last_bit_ = 1024;  // the exponent of the lowest bit set in any
};

}  // namespace tetloft::internal
