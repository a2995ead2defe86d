// Expansion arithmetic: exact sums and products of doubles as sums of doubles.
//
// An Expansion is a sum of components of increasing magnitude, none of them zero, strongly
// nonoverlapping: the sign of the value is the sign of the last component. Arrays are on
// the stack, their capacities computed from the operands' types.
//
// Exact as long as no operation over- or underflows; the callers prove that from the range
// of their arguments (exact.cpp). Requires rounding to nearest even.
//
// Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates", DCG 18, 1997, sections 2.2 to 2.5.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tetloft::internal {

/// A rounded result and what rounding lost: the exact result is value + error.
struct Rounded {
  double value;
  double error;
};

/// Knuth's sum of any two doubles (Shewchuk, theorem 7).
inline Rounded two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// Dekker's sum; requires |a| >= |b| or a == 0 (theorem 6).
inline Rounded fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline Rounded two_difference(double a, double b) { return two_sum(a, -b); }

/// A factor cut into two halves of at most 26 bits each, whose products are exact.
struct Halves {
  double whole;
  double high;
  double low;

  /// Veltkamp's splitting (theorem 17); 2^27 + 1 cuts 53 bits in the middle.
  explicit Halves(double a) : whole(a) {
    const double c = 0x1.0000002p+27 * a;
    high = c - (c - a);
    low = a - high;
  }
};

/// Dekker's and Veltkamp's product (theorem 18).
inline Rounded two_product(const Halves& a, const Halves& b) {
  const double product = a.whole * b.whole;
  const double e1 = product - a.high * b.high;
  const double e2 = e1 - a.low * b.high;
  const double e3 = e2 - a.high * b.low;
  return {product, a.low * b.low - e3};
}

/// No expansion of doubles has more components: they are multiples of 2^-1074 below 2^1024,
/// that is 2098 bit positions, and strongly nonoverlapping components (two of them may be
/// adjacent, never three, and only as powers of two) occupy at least three positions
/// for every two.
inline constexpr int kMostComponents = 1400;

template <int Capacity>
class Expansion {
 public:
  Expansion() = default;

  // Copies the components that exist; the rest of the array is never initialised.
  Expansion(const Expansion& other) : size_(other.size_) {
    std::copy_n(other.component_, size_, component_);
  }
  Expansion& operator=(const Expansion& other) {
    size_ = other.size_;
    std::copy_n(other.component_, size_, component_);
    return *this;
  }

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] double operator[](int i) const { return component_[i]; }
  [[nodiscard]] int sign() const { return size_ == 0 ? 0 : (component_[size_ - 1] > 0 ? 1 : -1); }

  /// Appends a component, which is larger than all before it; drops a zero.
  void append(double component) {
    component_[size_] = component;
    size_ += component != 0 ? 1 : 0;
  }
  void clear() { size_ = 0; }

 private:
  int size_ = 0;
  double component_[std::size_t{Capacity} + 1];  // one more, because a dropped zero is written too
};

inline Expansion<1> to_expansion(double value) {
  Expansion<1> result;
  result.append(value);
  return result;
}

inline Expansion<2> to_expansion(const Rounded& sum) {
  Expansion<2> result;
  result.append(sum.error);
  result.append(sum.value);
  return result;
}

inline constexpr int sum_capacity(int m, int n) { return std::min(m + n, kMostComponents); }
inline constexpr int product_capacity(int m, int n) { return std::min(2 * m * n, kMostComponents); }

/// result = e + f_sign · f (fast expansion sum with elimination of zeros, theorem 13).
template <int M, int N, int R>
void add(const Expansion<M>& e, const Expansion<N>& f, double f_sign, Expansion<R>& result) {
  result.clear();
  int i = 0;
  int j = 0;
  const auto next = [&] {
    if (j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]))) return e[i++];
    return f_sign * f[j++];
  };
  const int total = e.size() + f.size();
  if (total == 0) return;
  double sum = next();
  for (int k = 1; k < total; ++k) {
    const Rounded partial = two_sum(sum, next());
    result.append(partial.error);
    sum = partial.value;
  }
  result.append(sum);
}

/// result = e · factor (scale expansion with elimination of zeros, theorem 19).
template <int M, int R>
void scale(const Expansion<M>& e, double factor, Expansion<R>& result) {
  result.clear();
  if (e.size() == 0) return;
  const Halves f(factor);
  Rounded sum = two_product(Halves(e[0]), f);
  result.append(sum.error);
  for (int i = 1; i < e.size(); ++i) {
    const Rounded product = two_product(Halves(e[i]), f);
    const Rounded low = two_sum(sum.value, product.error);
    result.append(low.error);
    sum = fast_two_sum(product.value, low.value);
    result.append(sum.error);
  }
  result.append(sum.value);
}

template <int M, int N>
Expansion<sum_capacity(M, N)> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<sum_capacity(M, N)> result;
  add(e, f, 1.0, result);
  return result;
}

template <int M, int N>
Expansion<sum_capacity(M, N)> operator-(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<sum_capacity(M, N)> result;
  add(e, f, -1.0, result);
  return result;
}

/// Distributes over the components of f, the factor with the smaller capacity.
template <int M, int N>
Expansion<product_capacity(M, N)> operator*(const Expansion<M>& e, const Expansion<N>& f) {
  if constexpr (M < N) {
    return f * e;
  } else {
    Expansion<product_capacity(M, N)> result;
    if (f.size() == 0) return result;
    scale(e, f[0], result);
    if constexpr (N > 1) {
      Expansion<product_capacity(M, N)> sum;
      Expansion<product_capacity(M, 1)> term;
      for (int j = 1; j < f.size(); ++j) {
        scale(e, f[j], term);
        add(result, term, 1.0, sum);
        result = sum;
      }
    }
    return result;
  }
}

}  // namespace tetloft::internal
