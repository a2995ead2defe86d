// Schoolbook arithmetic on 64-bit limbs.
#include "arithmetic/big_integer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace tetloft::internal {

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  // frexp leaves at most 53 significant bits behind the point.
  mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  mantissa /= std::int64_t{1} << zeros;
  exponent += zeros;
}

BigInteger::BigInteger(Int128 value) : negative_(value < 0) {
  // Negation in unsigned arithmetic, so that the lowest value has a magnitude too.
  const auto bits = static_cast<Unsigned128>(value);
  const Unsigned128 magnitude = negative_ ? -bits : bits;
  limbs_ = {static_cast<std::uint64_t>(magnitude), static_cast<std::uint64_t>(magnitude >> 64)};
  settle();
}

BigInteger BigInteger::from_double(double value, int unit) {
  const Dyadic d(value);
  if (d.mantissa == 0) return {};
  return BigInteger(d.mantissa) << static_cast<std::size_t>(d.exponent - unit);
}

void BigInteger::settle() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  if (limbs_.empty()) negative_ = false;
}

std::size_t BigInteger::bits() const {
  if (limbs_.empty()) return 0;
  return 64 * limbs_.size() - static_cast<std::size_t>(std::countl_zero(limbs_.back()));
}

double BigInteger::to_double(int scale) const {
  // The three leading limbs hold at least 129 bits; what follows moves the sum by less
  // than the rounding does.
  double sum = 0;
  const std::size_t n = limbs_.size();
  for (std::size_t k = n - std::min<std::size_t>(n, 3); k < n; ++k) {
    sum = sum * 0x1p-64 + static_cast<double>(limbs_[k]);
  }
  if (n == 0) return 0;
  const double clamped = std::min(64.0 * static_cast<double>(n - 1) + scale, 1e6);
  const double value = std::ldexp(sum, static_cast<int>(clamped));
  return negative_ ? -value : value;
}

int BigInteger::compare_magnitudes(const BigInteger& a, const BigInteger& b) {
  if (a.limbs_.size() != b.limbs_.size()) return a.limbs_.size() < b.limbs_.size() ? -1 : 1;
  for (std::size_t k = a.limbs_.size(); k-- > 0;) {
    if (a.limbs_[k] != b.limbs_[k]) return a.limbs_[k] < b.limbs_[k] ? -1 : 1;
  }
  return 0;
}

// |a| + |b|
BigInteger BigInteger::add_magnitudes(const BigInteger& a, const BigInteger& b) {
  const std::vector<std::uint64_t>& longer =
      a.limbs_.size() < b.limbs_.size() ? b.limbs_ : a.limbs_;
  const std::vector<std::uint64_t>& shorter = &longer == &a.limbs_ ? b.limbs_ : a.limbs_;
  BigInteger sum;
  sum.limbs_.resize(longer.size() + 1);
  Unsigned128 carry = 0;
  for (std::size_t k = 0; k < longer.size(); ++k) {
    carry += longer[k];
    if (k < shorter.size()) carry += shorter[k];
    sum.limbs_[k] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  sum.limbs_.back() = static_cast<std::uint64_t>(carry);
  sum.settle();
  return sum;
}

// |a| − |b|, for |a| ≥ |b|
BigInteger BigInteger::subtract_magnitudes(const BigInteger& a, const BigInteger& b) {
  BigInteger difference = a;
  difference.negative_ = false;
  std::uint64_t borrow = 0;
  for (std::size_t k = 0; k < a.limbs_.size(); ++k) {
    const std::uint64_t digit = k < b.limbs_.size() ? b.limbs_[k] : 0;
    if (digit == 0 && borrow == 0) {
      if (k >= b.limbs_.size()) break;
      continue;
    }
    const std::uint64_t minuend = a.limbs_[k];
    difference.limbs_[k] = minuend - digit - borrow;
    borrow = minuend < digit || (minuend == digit && borrow != 0) ? 1 : 0;
  }
  difference.settle();
  return difference;
}

BigInteger BigInteger::operator-() const {
  BigInteger result = *this;
  result.negative_ = !negative_ && !limbs_.empty();
  return result;
}

BigInteger operator+(const BigInteger& a, const BigInteger& b) {
  BigInteger sum;
  if (a.negative_ == b.negative_) {
    sum = BigInteger::add_magnitudes(a, b);
    sum.negative_ = a.negative_ && !sum.limbs_.empty();
  } else if (BigInteger::compare_magnitudes(a, b) >= 0) {
    sum = BigInteger::subtract_magnitudes(a, b);
    sum.negative_ = a.negative_ && !sum.limbs_.empty();
  } else {
    sum = BigInteger::subtract_magnitudes(b, a);
    sum.negative_ = b.negative_;
  }
  return sum;
}

BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }

BigInteger operator*(const BigInteger& a, const BigInteger& b) {
  BigInteger product;
  product.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    // (2^64 − 1)² + 2 (2^64 − 1) < 2^128: a column never overflows.
    Unsigned128 carry = 0;
    for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
      carry += static_cast<Unsigned128>(a.limbs_[i]) * b.limbs_[j] + product.limbs_[i + j];
      product.limbs_[i + j] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    product.limbs_[i + b.limbs_.size()] = static_cast<std::uint64_t>(carry);
  }
  product.negative_ = a.negative_ != b.negative_;
  product.settle();
  return product;
}

BigInteger operator<<(const BigInteger& a, std::size_t shift) {
  if (a.limbs_.empty()) return a;
  BigInteger result;
  result.negative_ = a.negative_;
  const std::size_t whole = shift / 64;
  const std::size_t part = shift % 64;
  result.limbs_.assign(a.limbs_.size() + whole + 1, 0);
  for (std::size_t k = 0; k < a.limbs_.size(); ++k) {
    result.limbs_[k + whole] |= a.limbs_[k] << part;
    if (part != 0) result.limbs_[k + whole + 1] |= a.limbs_[k] >> (64 - part);
  }
  result.settle();
  return result;
}

}  // namespace tetloft::internal
