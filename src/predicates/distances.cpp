#include "predicates/distances.hpp"

#include <cmath>

#include "predicates/exact.hpp"
#include "predicates/filter.hpp"

namespace tetloft::internal::predicates {

namespace {

// 6 u of each, one more for the difference and the rounding of the bound. What underflows in three
// squares is far below the tiny term; where something overflows nothing is certain.
Sign certain_difference(double a, double b) {
  constexpr double kError = 8 * kRounding;
  constexpr double kTinySquares = 0x1p-1000;
  const double difference = a - b;
  if (!(std::abs(difference) > kError * (a + b) + kTinySquares)) return Sign::zero;
  return difference > 0 ? Sign::positive : Sign::negative;
}

}  // namespace

Sign compare_distances(const Point3& p, const Point3& a, double squared_a, const Point3& b,
                       double squared_b) {
  const Sign s = certain_difference(squared_a, squared_b);
  return s != Sign::zero ? s : exact_distances(p, a, b).sign;
}

Sign compare_distances(const Point3& p, const Point3& a, const Point3& b) {
  return compare_distances(p, a, squared_distance(p, a), b, squared_distance(p, b));
}

Sign compare_distance(const Point3& p, const Point3& a, double radius) {
  if (std::isinf(radius)) return Sign::negative;
  const Sign s = certain_difference(squared_distance(p, a), radius * radius);
  return s != Sign::zero ? s : exact_distance(p, a, radius).sign;
}

}  // namespace tetloft::internal::predicates
