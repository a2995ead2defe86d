// Point sets for Voronoi cells, many of them degenerate.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::test {

struct NamedPoints {
  std::string name;
  std::vector<Point3> points;
  int dimension = 3;
};
/// In the unit cube, from a few to some hundred points each.
[[nodiscard]] std::vector<NamedPoints> voronoi_point_sets();
[[nodiscard]] std::vector<Point3> uniform_points(std::size_t n, std::uint64_t seed);
/// (0, 0, 0) to (n − 1, n − 1, n − 1) over n − 1.
[[nodiscard]] std::vector<Point3> cubic_points(int n);

/// A value that is there, or a failed test that ends.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return *std::move(result);
}
[[nodiscard]] inline DelaunayTriangulation3 triangulated(const std::vector<Point3>& points) {
  return value_of(DelaunayTriangulation3::of(points));
}

}  // namespace tetloft::test
