// Two doubles at a time, where the processor can: each as if alone.
#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace tetloft::internal::predicates {

/// A ring for determinants.hpp: that of two sets of points at once, rounded as they would be one
/// after the other.
#if defined(__SSE2__)

class TwoDoubles {
 public:
  TwoDoubles(double first, double second) : both_(_mm_set_pd(second, first)) {}

  [[nodiscard]] double first() const { return _mm_cvtsd_f64(both_); }
  [[nodiscard]] double second() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(both_, both_)); }

  friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(_mm_add_pd(a.both_, b.both_));
  }
  friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(_mm_sub_pd(a.both_, b.both_));
  }
  friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
    return TwoDoubles(_mm_mul_pd(a.both_, b.both_));
  }

 private:
  explicit TwoDoubles(__m128d both) : both_(both) {}

  __m128d both_;
};

#else

class TwoDoubles {
 public:
  TwoDoubles(double first, double second) : first_(first), second_(second) {}

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double second() const { return second_; }

  friend TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
    return {a.first_ + b.first_, a.second_ + b.second_};
  }
  friend TwoDoubles operator-(const TwoDoubles& a, const TwoDoubles& b) {
    return {a.first_ - b.first_, a.second_ - b.second_};
  }
  friend TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
    return {a.first_ * b.first_, a.second_ * b.second_};
  }

 private:
  double first_;
  double second_;
};

#endif

}  // namespace tetloft::internal::predicates
