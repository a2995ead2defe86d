// x = (a t + (b - a) s) / t with t = high.z - low.z and s = z - low.z: a quotient of doubles twice
// as long, which tells the nearest double but where two are nearly as near; then by integers.
#include "sections/edge_crossing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "arithmetic/big_integer.hpp"
#include "arithmetic/double_double.hpp"

namespace tetloft::internal::sections {

namespace {

// One coordinate at the ends, and the heights.
struct Slope {
  double a, b;
  double low, high;
  double z;
};

struct Estimate {
  double value;
  bool certain;
};

// With u = 2^-53: the numerator is off by 21 u² (|a| + |b - a|) t at most (double_double.hpp), the
// quotient and the step after it add less than 45 u² of the value, which lies between a and b. All
// that is below 128 u² (|a| + |b|), here taken twice: 2^-98 (|a| + |b|), for the roundings below.
Estimate estimate(const Slope& s) {
  const double size = std::abs(s.a) + std::abs(s.b);
  const Rounded across = two_difference(s.high, s.low);
  const Rounded up = two_difference(s.z, s.low);
  const Rounded rise = two_difference(s.b, s.a);
  const DoubleDouble t{across.value, across.error};
  // No product over- or underflows between these.
  const bool safe = size > 0x1p-200 && size < 0x1p400 && t.high > 0x1p-400 && t.high < 0x1p400;
  if (!safe) {
    const double part = up.value / across.value;
    return {s.a + part * (s.b - s.a), false};
  }
  const DoubleDouble numerator = DoubleDouble{s.a, 0} * t + DoubleDouble{rise.value, rise.error} *
                                                                DoubleDouble{up.value, up.error};
  const double first = numerator.high / t.high;
  const DoubleDouble rest = numerator - DoubleDouble{first, 0} * t;
  const Rounded sum = two_sum(first, rest.high / t.high);
  const double bound = 0x1p-98 * size;
  const bool certain =
      sum.value + (sum.error + bound) == sum.value && sum.value + (sum.error - bound) == sum.value;
  return {sum.value, certain};
}

// The quotient, compared exactly.
class ExactSlope {
 public:
  explicit ExactSlope(const Slope& s) {
    const BigInteger a = integer(s.a);
    const BigInteger low = integer(s.low);
    across_ = integer(s.high) - low;
    numerator_ = a * across_ + (integer(s.b) - a) * (integer(s.z) - low);
  }

  // The sign of the quotient less the middle of c and d.
  [[nodiscard]] int beyond_middle(double c, double d) const {
    return (numerator_ + numerator_ - (integer(c) + integer(d)) * across_).sign();
  }

 private:
  // All doubles are multiples of this unit.
  static BigInteger integer(double value) { return BigInteger::from_double(value, -1074); }

  BigInteger across_;
  BigInteger numerator_;
};

// Doubles in their order as integers; both zeros are 0.
std::int64_t rank_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : INT64_MIN - bits;
}
double of_rank(std::int64_t rank) {
  return std::bit_cast<double>(rank >= 0 ? rank : INT64_MIN - rank);
}

bool is_nearest(const ExactSlope& exact, std::int64_t rank) {
  const double c = of_rank(rank);
  const bool even = rank % 2 == 0;
  const int above = exact.beyond_middle(c, of_rank(rank + 1));
  const int below = exact.beyond_middle(of_rank(rank - 1), c);
  return (even ? above <= 0 : above < 0) && (even ? below >= 0 : below > 0);
}

double nearest(const Slope& s, double guess) {
  const ExactSlope exact(s);
  if (is_nearest(exact, rank_of(guess))) return guess;
  // The lowest double that is not below the quotient, and the one before it.
  std::int64_t below = rank_of(std::min(s.a, s.b));
  std::int64_t above = rank_of(std::max(s.a, s.b));
  while (below + 1 < above) {
    const std::int64_t middle = std::midpoint(below, above);
    const double c = of_rank(middle);
    (exact.beyond_middle(c, c) > 0 ? below : above) = middle;
  }
  return of_rank(is_nearest(exact, below) ? below : above);
}

double at(const Slope& s) {
  if (s.a == s.b || s.z == s.high) return s.b + 0.0;  // −0 becomes 0
  const Estimate e = estimate(s);
  return (e.certain ? e.value : nearest(s, e.value)) + 0.0;
}

}  // namespace

Point2 crossing_at(const Point3& low, const Point3& high, double z) {
  return {at({low.x, high.x, low.z, high.z, z}), at({low.y, high.y, low.z, high.z, z})};
}

}  // namespace tetloft::internal::sections
