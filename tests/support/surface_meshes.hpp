// Closed surfaces for tests of slicing, turning counter-clockwise as seen from outside.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <tetloft/slice.hpp>

namespace tetloft::testing {

inline constexpr double kPi = 3.14159265358979323846;

inline void append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

/// The box between two corners; corner k has the upper x, y, z where bits 0, 1, 2 of k are set.
inline TriangleMesh box_mesh(const Point3& low, const Point3& high) {
  TriangleMesh mesh;
  for (unsigned k = 0; k < 8; ++k) {
    mesh.points.push_back({(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y,
                           (k & 4U) != 0 ? high.z : low.z});
  }
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// About the z axis through the origin: a ring of n steps, of radius `ring`, and a tube of m steps.
inline TriangleMesh torus_mesh(double ring, double tube, std::uint32_t n, std::uint32_t m) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * kPi * i / n;
    for (std::uint32_t k = 0; k < m; ++k) {
      const double v = 2 * kPi * k / m;
      const double r = ring + tube * std::cos(v);
      mesh.points.push_back({r * std::cos(u), r * std::sin(u), tube * std::sin(v)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return i % n * m + k % m; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < m; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

inline double volume_of(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Point3& a = mesh.points[t[0]];
    const Point3& b = mesh.points[t[1]];
    const Point3& c = mesh.points[t[2]];
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum / 6;
}

/// Of the region by crossing number, where contours turn as they bound it.
inline double area_of(const Section& section) {
  double sum = 0;
  for (const Contour& contour : section.contours) sum += twice_area(contour) / 2;
  return sum;
}

}  // namespace tetloft::testing
