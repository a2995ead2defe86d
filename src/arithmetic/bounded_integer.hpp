// Integers of bounded size on the stack: the arithmetic that no exponent range limits.
//
// Sign and magnitude; limbs of 32 bits, least significant first, the most significant one
// nonzero; zero has no limbs. Capacities follow from the operands' types, so nothing
// overflows. Speed does not matter here: only coordinates beyond 2^±160 come this far.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace tetloft::internal {

/// A finite double as mantissa · 2^exponent; mantissa 0 for zero.
struct Decomposed {
  bool negative;
  std::uint64_t mantissa;  // below 2^53
  int exponent;            // -1074 … 971

  explicit Decomposed(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>((bits >> 52) & 0x7FF);
    const std::uint64_t fraction = bits & 0xF'FFFF'FFFF'FFFF;
    negative = (bits >> 63) != 0;
    // A biased exponent of 0 marks denormals, which have no hidden bit.
    mantissa = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    exponent = (biased == 0 ? 1 : biased) - 1075;
  }
};

template <int Capacity>
class BoundedInteger {
 public:
  BoundedInteger() = default;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::uint32_t operator[](int i) const { return limb_[i]; }
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }
  [[nodiscard]] bool negative() const { return negative_; }

  /// Takes the first `size` limbs, already written through limbs(), less leading zeros.
  void settle(bool negative, int size) {
    while (size > 0 && limb_[size - 1] == 0) --size;
    size_ = size;
    negative_ = negative && size > 0;
  }
  [[nodiscard]] std::uint32_t* limbs() { return limb_; }

 private:
  int size_ = 0;
  bool negative_ = false;
  std::uint32_t limb_[std::size_t{Capacity}];
};

/// A coordinate in units of 2^-1074 needs 2098 bits, the difference of two 2099.
inline constexpr int kCoordinateLimbs = 66;
using BigCoordinate = BoundedInteger<kCoordinateLimbs>;

/// value / 2^unit. Requires unit not above Decomposed(value).exponent for nonzero values.
inline BigCoordinate to_big_integer(double value, int unit) {
  const Decomposed d(value);
  BigCoordinate result;
  if (d.mantissa == 0) return result;
  const int first = (d.exponent - unit) / 32;
  const int bits = (d.exponent - unit) % 32;
  std::uint32_t* limb = result.limbs();
  std::fill(limb, limb + first, 0U);
  const std::uint64_t low = (d.mantissa & 0xFFFF'FFFF) << bits;
  const std::uint64_t high = ((d.mantissa >> 32) << bits) + (low >> 32);
  const std::uint32_t parts[] = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high),
                                 static_cast<std::uint32_t>(high >> 32)};
  int size = first;
  for (const std::uint32_t part : parts) {
    if (size < kCoordinateLimbs) limb[size++] = part;  // only zeros can be left over
  }
  result.settle(d.negative, size);
  return result;
}

/// -1, 0 or 1 as |a| is less than, equal to or greater than |b|.
template <int M, int N>
int compare_magnitudes(const BoundedInteger<M>& a, const BoundedInteger<N>& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (int i = a.size() - 1; i >= 0; --i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

/// result = ±(|a| + |b|).
template <int M, int N, int R>
void add_magnitudes(const BoundedInteger<M>& a, const BoundedInteger<N>& b, bool negative,
                    BoundedInteger<R>& result) {
  std::uint64_t carry = 0;
  int i = 0;
  for (; i < std::max(a.size(), b.size()); ++i) {
    carry += i < a.size() ? a[i] : 0U;
    carry += i < b.size() ? b[i] : 0U;
    result.limbs()[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0) result.limbs()[i++] = static_cast<std::uint32_t>(carry);
  result.settle(negative, i);
}

/// result = ±(|a| − |b|). Requires |a| >= |b|.
template <int M, int N, int R>
void subtract_magnitudes(const BoundedInteger<M>& a, const BoundedInteger<N>& b, bool negative,
                         BoundedInteger<R>& result) {
  std::int64_t borrow = 0;
  for (int i = 0; i < a.size(); ++i) {
    borrow += std::int64_t{a[i]} - (i < b.size() ? std::int64_t{b[i]} : 0);
    result.limbs()[i] = static_cast<std::uint32_t>(borrow & 0xFFFF'FFFF);
    borrow >>= 32;
  }
  result.settle(negative, a.size());
}

template <int M, int N>
BoundedInteger<std::max(M, N) + 1> add_signed(const BoundedInteger<M>& a,
                                              const BoundedInteger<N>& b, bool b_negative) {
  BoundedInteger<std::max(M, N) + 1> result;
  if (a.negative() == b_negative) {
    add_magnitudes(a, b, a.negative(), result);
  } else if (compare_magnitudes(a, b) >= 0) {
    subtract_magnitudes(a, b, a.negative(), result);
  } else {
    subtract_magnitudes(b, a, b_negative, result);
  }
  return result;
}

template <int M, int N>
auto operator+(const BoundedInteger<M>& a, const BoundedInteger<N>& b) {
  return add_signed(a, b, b.negative());
}

template <int M, int N>
auto operator-(const BoundedInteger<M>& a, const BoundedInteger<N>& b) {
  return add_signed(a, b, !b.negative());
}

/// Schoolbook multiplication; a column never exceeds (2^32 − 1)² + 2 (2^32 − 1) < 2^64.
template <int M, int N>
BoundedInteger<M + N> operator*(const BoundedInteger<M>& a, const BoundedInteger<N>& b) {
  BoundedInteger<M + N> result;
  std::uint32_t* limb = result.limbs();
  std::fill(limb, limb + a.size() + b.size(), 0U);
  for (int i = 0; i < a.size(); ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size(); ++j) {
      carry += std::uint64_t{a[i]} * b[j] + limb[i + j];
      limb[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    limb[i + b.size()] = static_cast<std::uint32_t>(carry);
  }
  result.settle(a.negative() != b.negative(), a.size() + b.size());
  return result;
}

}  // namespace tetloft::internal
