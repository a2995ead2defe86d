// Integers without bound, for the few sums that intervals cannot decide.
//
// Sign and magnitude; limbs of 64 bits, least significant first, the most significant one
// nonzero; zero has no limbs and is not negative. Schoolbook multiplication: operands of
// more than a few thousand limbs do not occur on sensible data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetloft::internal {

/// 128 bits: room for the products of small lattice coordinates, and for a limb product.
__extension__ using Int128 = __int128;
__extension__ using Unsigned128 = unsigned __int128;

class BigInteger {
 public:
  BigInteger() = default;
  BigInteger(Int128 value);  // implicit: formulas mix both

  /// The integer value · 2^−unit. Requires that it is one.
  static BigInteger from_double(double value, int unit);

  [[nodiscard]] int sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }
  /// The number of bits of the magnitude.
  [[nodiscard]] std::size_t bits() const;
  /// The double next to value · 2^scale, at most one unit in the last place off; infinite
  /// or zero where that leaves the range of doubles.
  [[nodiscard]] double to_double(int scale = 0) const;

  BigInteger operator-() const;
  BigInteger& operator+=(const BigInteger& other) { return *this = *this + other; }
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator<<(const BigInteger& a, std::size_t shift);
  friend bool operator==(const BigInteger& a, const BigInteger& b) = default;
  friend bool operator<(const BigInteger& a, const BigInteger& b) { return (a - b).sign() < 0; }

 private:
  void settle();
  static int compare_magnitudes(const BigInteger& a, const BigInteger& b);
  static BigInteger add_magnitudes(const BigInteger& a, const BigInteger& b);
  static BigInteger subtract_magnitudes(const BigInteger& a, const BigInteger& b);

  std::vector<std::uint64_t> limbs_;
  bool negative_ = false;
};

/// value = mantissa · 2^exponent with an odd mantissa (or zero) of at most 53 bits.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
  explicit Dyadic(double value);
};

}  // namespace tetloft::internal
