// Filters in a unit of each axis's own: for points that are thin, or far, along an axis. Where z
// is denormal, say, the bounds of filter.hpp exceed every determinant, and integers of a thousand
// bits would have to answer.
//
// Multiplying a column of a determinant by a power of two keeps its sign, and the lift is a column
// of its own: what is thin in z stays thin in the lift, and only there. So the columns of
// differences are each brought to a largest magnitude in [1, 2), and the lift is that of the
// differences in the unit of the largest axis. Roundings are those that filter.hpp counts.
// Underflow: a number is scaled with an error of 2^-1075 at most, and no factor beside it exceeds
// 2, a lift 12: with that of the products, less than 2^-1060 in total, which kTiny covers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <tetloft/point.hpp>

#include "predicates/determinants.hpp"
#include "predicates/filter.hpp"

namespace tetloft::internal::predicates {

/// The differences p[i] − q by axis, and the largest magnitude on each.
template <std::size_t n>
struct AxisDifferences {
  std::array<std::array<double, n>, 3> value;
  std::array<double, 3> largest{};

  AxisDifferences(const std::array<const Point3*, n>& p, const Point3& q) {
    for (std::size_t i = 0; i < n; ++i) {
      value[0][i] = p[i]->x - q.x;
      value[1][i] = p[i]->y - q.y;
      value[2][i] = p[i]->z - q.z;
      for (std::size_t k = 0; k < 3; ++k) largest[k] = std::max(largest[k], std::abs(value[k][i]));
    }
  }

  /// Do the filters without units fail for underflow or for their limit? Then they are of use.
  [[nodiscard]] bool are_uneven() const {
    const auto [least, most] = std::minmax({largest[0], largest[1], largest[2]});
    constexpr double kThin = 0x1p-60;
    return least > 0 && std::isfinite(most) && (least < kThin || most > kLargest);
  }

  /// Axis k times 2^exponent.
  [[nodiscard]] std::array<double, n> scaled(std::size_t k, int exponent) const {
    std::array<double, n> result;
    for (std::size_t i = 0; i < n; ++i) result[i] = std::ldexp(value[k][i], exponent);
    return result;
  }
  [[nodiscard]] std::array<double, n> in_own_unit(std::size_t k) const {
    return scaled(k, -std::ilogb(largest[k]));
  }
};

/// The sign of orient3d, or 0 where it is not certain.
inline int orient3d_axis_filter(const Point3& a, const Point3& b, const Point3& c,
                                const Point3& d) {
  const AxisDifferences<3> difference({&b, &c, &d}, a);
  if (!difference.are_uneven()) return 0;
  const auto x = difference.in_own_unit(0);
  const auto y = difference.in_own_unit(1);
  const auto z = difference.in_own_unit(2);
  return certain_sign(orient3d_determinant(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]),
                      kOrient3dError * largest(x[0], x[1], x[2]) * largest(y[0], y[1], y[2]) *
                              largest(z[0], z[1], z[2]) +
                          kTiny);
}

/// The sign of insphere, or 0 where it is not certain.
inline int insphere_axis_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const Point3& e) {
  const AxisDifferences<4> difference({&a, &b, &c, &d}, e);
  if (!difference.are_uneven()) return 0;
  const auto x = difference.in_own_unit(0);
  const auto y = difference.in_own_unit(1);
  const auto z = difference.in_own_unit(2);
  const int unit =
      -std::ilogb(largest(difference.largest[0], difference.largest[1], difference.largest[2]));
  std::array<double, 4> lift{};
  double squares = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto v = difference.scaled(k, unit);
    for (std::size_t i = 0; i < 4; ++i) lift[i] += v[i] * v[i];
    const double most = largest(v[0], v[1], v[2], v[3]);
    squares += most * most;
  }
  return certain_sign(
      lifted_insphere_determinant(x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2], x[3], y[3],
                                  z[3], lift[0], lift[1], lift[2], lift[3]),
      kInsphereError * largest(x[0], x[1], x[2], x[3]) * largest(y[0], y[1], y[2], y[3]) *
              largest(z[0], z[1], z[2], z[3]) * squares +
          kTiny);
}

}  // namespace tetloft::internal::predicates
