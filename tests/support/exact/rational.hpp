// Exact rational numbers for test oracles.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "support/exact/big_int.hpp"

namespace tetloft::oracle {

/// Always in lowest terms with a positive denominator.
class Rational {
 public:
  Rational() : denominator_(1) {}
  Rational(std::int64_t value) : numerator_(value), denominator_(1) {}  // implicit: literals
  /// Requires a nonzero denominator.
  Rational(BigInt numerator, BigInt denominator);

  /// The exact value of a finite double.
  static Rational exactly(double value);

  [[nodiscard]] const BigInt& numerator() const { return numerator_; }
  [[nodiscard]] const BigInt& denominator() const { return denominator_; }
  [[nodiscard]] int sign() const { return numerator_.sign(); }
  [[nodiscard]] Rational abs() const;
  /// Close to the nearest double (relative error below 2^-49, unless it is denormal).
  [[nodiscard]] double approximate() const;
  /// "0x3/0x4".
  [[nodiscard]] std::string to_string() const;

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  /// Requires b nonzero.
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a);
  friend bool operator==(const Rational&, const Rational&) = default;
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

 private:
  BigInt numerator_;
  BigInt denominator_;
};

}  // namespace tetloft::oracle
