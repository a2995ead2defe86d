// Two doubles at a time, where the processor can: each as if alone.
#pragma once

#include <cstddef>

namespace tetloft::internal::predicates {

/// A ring for determinants.hpp: that of two sets of points at once, each rounded as if alone.
class TwoDoubles {
 public:
  TwoDoubles(double first, double second) : both_{first, second} {}

  [[nodiscard]] double first() const { return both_[0]; }
  [[nodiscard]] double second() const { return both_[1]; }

  friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(a.both_ + b.both_);
  }
  friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(a.both_ - b.both_);
  }
  friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(a.both_ * b.both_);
  }

 private:
#if defined(__GNUC__)
  // What gcc and clang hold in one register of the processor, if it has such, and compute with one
  // instruction.
  using Both = double __attribute__((vector_size(2 * sizeof(double))));
#else
  struct Both {
    double value[2];

    double operator[](std::size_t i) const { return value[i]; }
    friend Both operator+(const Both& a, const Both& b) { return {a[0] + b[0], a[1] + b[1]}; }
    friend Both operator-(const Both& a, const Both& b) { return {a[0] - b[0], a[1] - b[1]}; }
    friend Both operator*(const Both& a, const Both& b) { return {a[0] * b[0], a[1] * b[1]}; }
  };
#endif

  explicit TwoDoubles(const Both& both) : both_(both) {}

  Both both_;
};

}  // namespace tetloft::internal::predicates
