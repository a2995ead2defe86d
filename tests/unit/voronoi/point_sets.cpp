#include "point_sets.hpp"

#include <cmath>

#include "core/prng.hpp"

namespace tetloft::test {

using internal::Prng;

std::vector<Point3> uniform_points(std::size_t n, std::uint64_t seed) {
  Prng prng(seed);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({prng.unit(), prng.unit(), prng.unit()});
  return points;
}

std::vector<Point3> cubic_points(int n) {
  std::vector<Point3> points;
  for (int i = 0; i < n * n * n; ++i) {
    const double scale = 1.0 / (n - 1);
    points.push_back({scale * (i % n), scale * (i / n % n), scale * (i / n / n)});
  }
  return points;
}

std::vector<NamedPoints> voronoi_point_sets() {
  constexpr std::uint64_t kSeed = 20;
  std::vector<NamedPoints> sets;
  sets.push_back({"uniform", uniform_points(300, kSeed)});
  sets.push_back({"lattice", cubic_points(6)});
  Prng prng(kSeed);
  NamedPoints nearly{"lattice with ulps", cubic_points(5)};
  for (Point3& p : nearly.points) p.x += prng.chance(0.5) ? 0x1p-52 : -0x1p-53;
  sets.push_back(nearly);
  NamedPoints sphere{"sphere", {}};
  for (const Point3& p : uniform_points(200, kSeed + 1)) {
    const double x = p.x - 0.5, y = p.y - 0.5, z = p.z - 0.5;
    const double length = 2.5 * std::sqrt(x * x + y * y + z * z);
    sphere.points.push_back({0.5 + x / length, 0.5 + y / length, 0.5 + z / length});
  }
  sets.push_back(sphere);
  NamedPoints clusters{"clusters", {}};
  for (int k = 0; k < 40; k += 4) {
    for (const Point3& p : uniform_points(12, kSeed + 2 + static_cast<std::uint64_t>(k))) {
      clusters.points.push_back({0.3 + std::ldexp(p.x, -k) / 2, 0.4 + std::ldexp(p.y, -k) / 2,
                                 0.1 + std::ldexp(p.z, -k) / 2});
    }
  }
  sets.push_back(clusters);
  NamedPoints plane{"plane", {}, 2}, grid{"grid in a plane", {}, 2}, row{"row", {}, 1};
  for (const Point3& p : uniform_points(100, kSeed + 3)) plane.points.push_back({p.x, p.y, 0.25});
  for (int i = 0; i < 49; ++i) {
    grid.points.push_back({(i % 7) / 8.0, (i / 7) / 8.0, 0.5 + (i % 7) / 16.0});
  }
  for (int i = 0; i < 9; ++i) row.points.push_back({i / 8.0, i / 16.0, 0.125 + i / 32.0});
  sets.push_back(plane);
  sets.push_back(grid);
  sets.push_back(row);
  sets.push_back({"one", {{0.25, 0.5, 0.75}}, 0});
  sets.push_back({"two", {{0.25, 0.5, 0.75}, {0.5, 0.5, 0.5}}, 1});
  sets.push_back({"three", {{0.25, 0.5, 0.75}, {0.5, 0.5, 0.5}, {0.1, 0.2, 0.3}}, 2});
  sets.push_back({"outside", {{-3, 0.5, 0.75}, {2.5, 0.5, 0.5}, {0.1, 9, 0.3}, {0, 0, -80}}});
  return sets;
}

}  // namespace tetloft::test
