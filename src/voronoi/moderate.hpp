// Which coordinates cells are computed of.
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

}  // namespace tetloft::internal::voronoi
