// Which coordinates cells are computed of, and how they are brought near 1.
#pragma once

#include <cmath>

#include <tetloft/point.hpp>

namespace tetloft::internal::voronoi {

/// Below, products of three coordinates are finite.
inline constexpr double kMostCoordinate = 0x1p300;

/// False also for what is not finite.
[[nodiscard]] inline bool is_moderate(const Point3& p) {
  return std::abs(p.x) <= kMostCoordinate && std::abs(p.y) <= kMostCoordinate &&
         std::abs(p.z) <= kMostCoordinate;
}

/// p · 2^exponent.
[[nodiscard]] inline Point3 times_power_of_two(const Point3& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
}

}  // namespace tetloft::internal::voronoi
