#include "model/corner_normals.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/vector.hpp"

namespace tetloft::internal {

namespace {

// A vertex of more faces than this is smoothed over its first faces only: fans around one vertex
// would take quadratic time.
constexpr std::uint32_t kMostFaces = 512;

}  // namespace

std::vector<std::array<Point3, 3>> corner_normals(
    const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  using namespace vectors;
  const std::size_t n = triangles.size();
  // Corners 3 k + i by vertex: corner[first[v]] …
  std::vector<std::uint32_t> first(points.size() + 1, 0);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < 3; ++i) ++first[triangles[k][i] + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<std::uint32_t> corner(3 * n);
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  std::vector<Point3> area(n), own(n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto& [a, b, c] = triangles[k];
    area[k] = cross(points[b] - points[a], points[c] - points[a]);
    own[k] = unit(area[k]);
    for (std::size_t i = 0; i < 3; ++i) {
      corner[next[triangles[k][i]]++] = static_cast<std::uint32_t>(3 * k + i);
    }
  }
  std::vector<std::array<Point3, 3>> normals(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = triangles[k][i];
      const std::uint32_t end = std::min(first[v + 1], first[v] + kMostFaces);
      Point3 sum = area[k];
      for (std::uint32_t c = first[v]; c < end; ++c) {
        const std::size_t other = corner[c] / 3;
        if (other != k && dot(own[other], own[k]) >= kCrease) sum = sum + area[other];
      }
      normals[k][i] = unit(sum, own[k]);
    }
  }
  return normals;
}

}  // namespace tetloft::internal
