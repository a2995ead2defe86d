// The area of a polygon in space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

#include "core/vector.hpp"

namespace tetloft::internal::voronoi {

/// Twice the area as a vector, of corners that are at point(corner); zero of fewer than three.
template <class PointOf>
[[nodiscard]] Point3 twice_area(const std::vector<std::uint32_t>& corners, const PointOf& point) {
  using namespace vectors;
  Point3 sum;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Point3& first = point(corners[0]);
    sum = sum + cross(point(corners[i - 1]) - first, point(corners[i]) - first);
  }
  return sum;
}

}  // namespace tetloft::internal::voronoi
