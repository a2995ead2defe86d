#include "check/winding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "unit/check/columns.hpp"

namespace tetloft {

using namespace internal;
namespace {

// Adds the surface of a cube, outward or inward; returns nothing of it shared.
struct Cubes {
  std::vector<Point3> points;
  std::vector<TriangleVertices> triangles;
  std::vector<std::uint32_t> component;
  std::uint32_t count = 0;

  void add(const Point3& corner, double side, bool outward) {
    testing::Case cube = testing::extrude({{testing::square_shape(), {0, 4}}}, {0, 4});
    for (TriangleVertices t : boundary_surface(cube.model).triangles) {
      if (!outward) std::swap(t[1], t[2]);
      for (VertexId& v : t) v = VertexId(v.value() + points.size());
      triangles.push_back(t);
      component.push_back(count);
    }
    for (const Point3& p : cube.model.points) {
      points.push_back(
          {corner.x + side * p.x / 4, corner.y + side * p.y / 4, corner.z + side * p.z / 4});
    }
    ++count;
  }
  [[nodiscard]] std::vector<long> winding() const {
    return checking::outer_winding(points, triangles, component, count);
  }
};

TEST(OuterWinding, OfDisjointBodiesIsZero) {
  Cubes cubes;
  cubes.add({0, 0, 0}, 4, true);
  cubes.add({0, 0, 8}, 4, true);
  cubes.add({8, 0, 0}, 4, true);
  EXPECT_EQ(cubes.winding(), (std::vector<long>{0, 0, 0}));
}

TEST(OuterWinding, OfACavityIsZero) {
  Cubes cubes;
  cubes.add({0, 0, 0}, 4, true);
  cubes.add({1, 1, 1}, 2, false);
  EXPECT_EQ(cubes.winding(), (std::vector<long>{0, 0}));
}

TEST(OuterWinding, OfABodyInACavityIsZero) {
  Cubes cubes;
  cubes.add({0, 0, 0}, 4, true);
  cubes.add({1, 1, 1}, 2, false);
  cubes.add({1.5, 1.5, 1.5}, 1, true);
  EXPECT_EQ(cubes.winding(), (std::vector<long>{0, 0, 0}));
}

TEST(OuterWinding, OfABodyInABodyIsOne) {
  Cubes cubes;
  cubes.add({0, 0, 0}, 8, true);
  cubes.add({1, 1, 1}, 4, true);
  cubes.add({2, 2, 2}, 1, true);
  EXPECT_EQ(cubes.winding(), (std::vector<long>{0, 1, 2}));
}

TEST(OuterWinding, OfACavityInNothingIsNegative) {
  Cubes cubes;
  cubes.add({0, 0, 0}, 1, false);
  EXPECT_EQ(cubes.winding(), (std::vector<long>{-1}));
}

TEST(OuterWinding, SeesThroughAlignedEdgesAndVertices) {
  // On one another and beside one another on a lattice: every ray from a corner meets edges.
  Cubes cubes;
  for (int x = 0; x < 3; ++x) {
    for (int z = 0; z < 4; ++z) cubes.add({2.0 * x, 0, 2.0 * z}, 1, true);
  }
  EXPECT_EQ(cubes.winding(), std::vector<long>(12, 0));
}

}  // namespace
}  // namespace tetloft
