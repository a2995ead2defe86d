#include "support/exact/rational.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::oracle {

namespace {

/// n / d. Requires that d > 0 divides n >= 0: long division by shifts.
BigInt exact_quotient(BigInt n, const BigInt& d) {
  BigInt quotient;
  while (n.sign() != 0) {
    int shift = n.bits() - d.bits();
    if (d.shifted_left(shift) > n) --shift;
    quotient = quotient + BigInt(1).shifted_left(shift);
    n = n - d.shifted_left(shift);
  }
  return quotient;
}

}  // namespace

Rational::Rational(BigInt numerator, BigInt denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
  if (denominator_.sign() < 0) {
    numerator_ = -numerator_;
    denominator_ = -denominator_;
  }
  if (numerator_.sign() == 0) {
    denominator_ = 1;
    return;
  }
  // Doubles have denominators 2^k: common factors of two go first, often that is all.
  const int twos = std::min(numerator_.trailing_zeros(), denominator_.trailing_zeros());
  numerator_ = numerator_.shifted_right(twos);
  denominator_ = denominator_.shifted_right(twos);
  if (denominator_.trailing_zeros() + 1 == denominator_.bits()) return;
  const BigInt common = gcd(numerator_, denominator_);
  if (common == BigInt(1)) return;
  const int sign = numerator_.sign();
  numerator_ = BigInt(sign) * exact_quotient(numerator_.abs(), common);
  denominator_ = exact_quotient(denominator_, common);
}

Rational Rational::exactly(double value) {
  const int exponent = BigInt::exponent_of(value);
  if (value == 0) return 0;
  if (exponent >= 0) return {BigInt::from_scaled(value, 0), 1};
  return {BigInt::from_scaled(value, exponent), BigInt(1).shifted_left(-exponent)};
}

Rational Rational::abs() const { return sign() < 0 ? -*this : *this; }

double Rational::approximate() const {
  // 64 bits of each decide, wherever their exponents are.
  const int up = std::max(0, numerator_.bits() - 64);
  const int down = std::max(0, denominator_.bits() - 64);
  return std::ldexp(
      numerator_.shifted_right(up).approximate() / denominator_.shifted_right(down).approximate(),
      up - down);
}

std::string Rational::to_string() const {
  return numerator_.to_string() + "/" + denominator_.to_string();
}

Rational operator+(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_,
          a.denominator_ * b.denominator_};
}

Rational operator-(const Rational& a, const Rational& b) { return a + -b; }

Rational operator*(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
}

Rational operator/(const Rational& a, const Rational& b) {
  return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
}

Rational operator-(const Rational& a) {
  Rational result = a;
  result.numerator_ = -result.numerator_;
  return result;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return a.numerator_ * b.denominator_ <=> b.numerator_ * a.denominator_;
}

}  // namespace tetloft::oracle
