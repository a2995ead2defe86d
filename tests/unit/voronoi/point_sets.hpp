// Point sets for Voronoi cells, many of them degenerate.
#pragma once

#include <string>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "support/value_of.hpp"

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

[[nodiscard]] inline DelaunayTriangulation3 triangulated(const std::vector<Point3>& points) {
  return value_of(DelaunayTriangulation3::of(points));
}

}  // namespace tetloft::test
