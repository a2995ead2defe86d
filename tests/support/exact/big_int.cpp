#include "support/exact/big_int.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetloft::oracle {

namespace {

using Limbs = std::vector<std::uint32_t>;

int compare(const Limbs& a, const Limbs& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

std::uint64_t limb_or_zero(const Limbs& a, std::size_t i) { return i < a.size() ? a[i] : 0; }

Limbs sum(const Limbs& a, const Limbs& b) {
  Limbs result;
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < a.size() || i < b.size() || carry != 0; ++i) {
    const std::uint64_t column = limb_or_zero(a, i) + limb_or_zero(b, i) + carry;
    result.push_back(static_cast<std::uint32_t>(column));
    carry = column >> 32;
  }
  return result;
}

/// Requires a >= b.
Limbs difference(const Limbs& a, const Limbs& b) {
  Limbs result;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::uint64_t column =
        (std::uint64_t{1} << 32) + limb_or_zero(a, i) - limb_or_zero(b, i) - borrow;
    result.push_back(static_cast<std::uint32_t>(column));
    borrow = 1 - (column >> 32);
  }
  return result;
}

}  // namespace

BigInt::BigInt(std::int64_t value) : negative_(value < 0) {
  auto magnitude = static_cast<std::uint64_t>(value);
  if (negative_) magnitude = 0 - magnitude;
  limbs_ = {static_cast<std::uint32_t>(magnitude), static_cast<std::uint32_t>(magnitude >> 32)};
  trim();
}

void BigInt::trim() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  if (limbs_.empty()) negative_ = false;
}

BigInt BigInt::from_scaled(double value, int exponent) {
  int e = 0;
  const double fraction = std::frexp(value, &e);
  const BigInt mantissa(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
  const int shift = e - 53 - exponent;
  return shift >= 0 ? mantissa.shifted_left(shift) : mantissa.shifted_right(-shift);
}

int BigInt::exponent_of(double value) {
  if (value == 0) return 1023;
  int e = 0;
  const double fraction = std::frexp(value, &e);
  return e - 53 + BigInt(static_cast<std::int64_t>(std::ldexp(fraction, 53))).trailing_zeros();
}

int BigInt::sign() const { return limbs_.empty() ? 0 : (negative_ ? -1 : 1); }

BigInt BigInt::abs() const { return negative_ ? -*this : *this; }

int BigInt::bits() const {
  if (limbs_.empty()) return 0;
  int top = 0;
  for (std::uint32_t limb = limbs_.back(); limb != 0; limb >>= 1) ++top;
  return 32 * static_cast<int>(limbs_.size() - 1) + top;
}

int BigInt::trailing_zeros() const {
  if (limbs_.empty()) return 0;
  std::size_t i = 0;
  while (limbs_[i] == 0) ++i;
  int low = 0;
  while ((limbs_[i] >> low & 1U) == 0) ++low;
  return 32 * static_cast<int>(i) + low;
}

BigInt BigInt::shifted_left(int bits) const {
  BigInt result;
  result.negative_ = negative_;
  result.limbs_.assign(static_cast<std::size_t>(bits / 32), 0);
  std::uint64_t carry = 0;
  for (const std::uint32_t limb : limbs_) {
    const std::uint64_t wide = (std::uint64_t{limb} << (bits % 32)) | carry;
    result.limbs_.push_back(static_cast<std::uint32_t>(wide));
    carry = wide >> 32;
  }
  result.limbs_.push_back(static_cast<std::uint32_t>(carry));
  result.trim();
  return result;
}

BigInt BigInt::shifted_right(int bits) const {
  BigInt result;
  result.negative_ = negative_;
  for (auto i = static_cast<std::size_t>(bits / 32); i < limbs_.size(); ++i) {
    const std::uint64_t wide = limb_or_zero(limbs_, i + 1) << 32 | limbs_[i];
    result.limbs_.push_back(static_cast<std::uint32_t>(wide >> (bits % 32)));
  }
  result.trim();
  return result;
}

double BigInt::approximate() const {
  double result = 0;
  const std::size_t n = limbs_.size();
  for (std::size_t i = n; i-- > 0 && i + 3 >= n;) {
    result += std::ldexp(static_cast<double>(limbs_[i]), 32 * static_cast<int>(i));
  }
  return negative_ ? -result : result;
}

std::string BigInt::to_string() const {
  if (limbs_.empty()) return "0x0";
  std::string digits;
  for (const std::uint32_t limb : limbs_) {
    for (int shift = 0; shift < 32; shift += 4) {
      digits.push_back("0123456789abcdef"[limb >> shift & 15U]);
    }
  }
  digits.erase(digits.find_last_not_of('0') + 1);
  std::reverse(digits.begin(), digits.end());
  return (negative_ ? "-0x" : "0x") + digits;
}

BigInt operator-(const BigInt& a) {
  BigInt result = a;
  result.negative_ = !a.negative_;
  result.trim();
  return result;
}

BigInt operator+(const BigInt& a, const BigInt& b) {
  BigInt result;
  if (a.negative_ == b.negative_) {
    result.limbs_ = sum(a.limbs_, b.limbs_);
    result.negative_ = a.negative_;
  } else if (compare(a.limbs_, b.limbs_) >= 0) {
    result.limbs_ = difference(a.limbs_, b.limbs_);
    result.negative_ = a.negative_;
  } else {
    result.limbs_ = difference(b.limbs_, a.limbs_);
    result.negative_ = b.negative_;
  }
  result.trim();
  return result;
}

BigInt operator-(const BigInt& a, const BigInt& b) { return a + -b; }

BigInt operator*(const BigInt& a, const BigInt& b) {
  BigInt result;
  result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
      const std::uint64_t column =
          std::uint64_t{a.limbs_[i]} * b.limbs_[j] + result.limbs_[i + j] + carry;
      result.limbs_[i + j] = static_cast<std::uint32_t>(column);
      carry = column >> 32;
    }
    result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
  }
  result.negative_ = a.negative_ != b.negative_;
  result.trim();
  return result;
}

std::strong_ordering operator<=>(const BigInt& a, const BigInt& b) {
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  const int order = compare(a.limbs_, b.limbs_);
  return (a.negative_ ? -order : order) <=> 0;
}

// Binary: subtraction and shifts only.
BigInt gcd(BigInt a, BigInt b) {
  a = a.abs();
  b = b.abs();
  if (a.sign() == 0) return b;
  if (b.sign() == 0) return a;
  const int common = std::min(a.trailing_zeros(), b.trailing_zeros());
  a = a.shifted_right(a.trailing_zeros());
  while (b.sign() != 0) {
    b = b.shifted_right(b.trailing_zeros());
    if (b < a) std::swap(a, b);
    b = b - a;
  }
  return a.shifted_left(common);
}

}  // namespace tetloft::oracle
