// Which of two points is nearer to a third, exactly.
#pragma once

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

namespace tetloft::internal::predicates {

/// |a − p|², rounded: its relative error is below 6 u, as a difference is off by u, its square by 3
/// u and the sum of three by 2 u more (and higher orders), but for underflow.
[[nodiscard]] inline double squared_distance(const Point3& p, const Point3& a) {
  const double x = a.x - p.x, y = a.y - p.y, z = a.z - p.z;
  return x * x + y * y + z * z;
}

/// Negative iff a is nearer to p than b, zero iff both are equally near.
[[nodiscard]] Sign compare_distances(const Point3& p, const Point3& a, const Point3& b);
/// The same with the squared distances of a and b known.
[[nodiscard]] Sign compare_distances(const Point3& p, const Point3& a, double squared_a,
                                     const Point3& b, double squared_b);
/// Negative iff a is nearer to p than `radius`, which is not negative and may be infinite.
[[nodiscard]] Sign compare_distance(const Point3& p, const Point3& a, double radius);

}  // namespace tetloft::internal::predicates
