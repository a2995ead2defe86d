// Integers of any size, plain and slow: the arithmetic tests trust.
//
// Shares no code with the library. Sign and magnitude, 32-bit limbs on the heap.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace tetloft::oracle {

class BigInt {
 public:
  BigInt() = default;
  BigInt(std::int64_t value);  // implicit: literals stand for themselves

  /// value / 2^exponent. Requires that value is finite and this is an integer.
  static BigInt from_scaled(double value, int exponent);
  /// The largest e such that value is a multiple of 2^e; 1023 for zero.
  static int exponent_of(double value);

  /// -1, 0 or 1.
  [[nodiscard]] int sign() const;
  [[nodiscard]] BigInt abs() const;
  /// Bits of the magnitude; 0 for zero.
  [[nodiscard]] int bits() const;
  /// How often 2 divides; 0 for zero.
  [[nodiscard]] int trailing_zeros() const;
  [[nodiscard]] BigInt shifted_left(int bits) const;
  /// The magnitude is shifted, so this rounds towards zero.
  [[nodiscard]] BigInt shifted_right(int bits) const;
  /// Nearest double or infinity, up to a relative error of 2^-51.
  [[nodiscard]] double approximate() const;
  /// Hexadecimal with sign.
  [[nodiscard]] std::string to_string() const;

  friend BigInt operator+(const BigInt& a, const BigInt& b);
  friend BigInt operator-(const BigInt& a, const BigInt& b);
  friend BigInt operator*(const BigInt& a, const BigInt& b);
  friend BigInt operator-(const BigInt& a);
  friend bool operator==(const BigInt&, const BigInt&) = default;
  friend std::strong_ordering operator<=>(const BigInt& a, const BigInt& b);

 private:
  void trim();

  bool negative_ = false;             // never for zero
  std::vector<std::uint32_t> limbs_;  // least significant first, the last one nonzero
};

/// Greatest common divisor of the magnitudes; gcd(0, b) = |b|.
[[nodiscard]] BigInt gcd(BigInt a, BigInt b);

}  // namespace tetloft::oracle
