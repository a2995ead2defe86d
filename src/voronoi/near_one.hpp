// Simplices brought near 1, where determinants of their edges stay in the range of doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <tetloft/point.hpp>

#include "core/vector.hpp"
#include "voronoi/moderate.hpp"

namespace tetloft::internal::voronoi {

/// The largest coordinate in magnitude of a difference from p[0].
template <std::size_t N>
[[nodiscard]] double largest_difference(const std::array<Point3, N>& p) {
  double largest = 0;
  for (std::size_t i = 1; i < N; ++i) {
    largest = std::max(
        {largest, std::abs(p[i].x - p[0].x), std::abs(p[i].y - p[0].y), std::abs(p[i].z - p[0].z)});
  }
  return largest;
}

/// Where that is so far from 1 that products of seven differences might leave the range of doubles,
/// or what they are exact by, divides all points by a power of two near it; its exponent, else 0.
template <std::size_t N>
[[nodiscard]] int bring_near_one(std::array<Point3, N>& p, double largest) {
  if (largest > 0x1p-40 && largest < 0x1p100) return 0;
  const int exponent = std::ilogb(largest) + 1;
  for (Point3& q : p) q = times_power_of_two(q, -exponent);
  return exponent;
}

/// The product of the edges' lengths at p[0]: the determinant of a corner of a square or cube.
template <std::size_t N>
[[nodiscard]] double product_of_edges(const std::array<Point3, N>& p) {
  double product = 1;
  for (std::size_t i = 1; i < N; ++i) {
    const Point3 edge{p[i].x - p[0].x, p[i].y - p[0].y, p[i].z - p[0].z};
    product *= std::sqrt(vectors::dot(edge, edge));
  }
  return product;
}

}  // namespace tetloft::internal::voronoi
