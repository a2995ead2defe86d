// The plain triangulation against its definition.
#include <algorithm>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "plane_oracles.hpp"

namespace tetloft::test {
namespace {

void expect_brute_force(const Points& points) {
  const Triangulation2 t = triangulate(points);
  EXPECT_TRUE(is_canonical(t));
  EXPECT_EQ(t.triangles.raw(), brute_force_triangles(points));
}

TEST(Delaunay2, UniformSetsMatchBruteForce) {
  Prng prng(1);
  for (std::size_t n = 3; n <= 14; ++n) expect_brute_force(uniform(n, prng));
}

TEST(Delaunay2, LatticesMatchBruteForce) {
  for (int nx = 2; nx <= 4; ++nx) {
    for (int ny = 2; ny <= 4; ++ny) {
      Points points = lattice(nx, ny);
      Prng(7).shuffle(points);
      expect_brute_force(points);
      expect_brute_force(times(points, 0.1));
    }
  }
}

TEST(Delaunay2, GridSubsetsMatchBruteForce) {
  Prng prng(2);
  for (int k = 0; k < 20; ++k) {
    expect_brute_force(grid_subset(3 + prng.below(10), 4, prng));
    expect_brute_force(grid_subset(3 + prng.below(10), 8, prng));
  }
}

TEST(Delaunay2, CocircularSetsMatchBruteForce) {
  Prng prng(3);
  for (const int squared_radius : {1, 5, 25, 65}) {
    Points points = integer_circle(squared_radius);
    prng.shuffle(points);
    expect_brute_force(points);
    points.push_back({0, 0});
    expect_brute_force(points);
  }
}

TEST(Delaunay2, SetsOnTwoLinesMatchBruteForce) {
  Prng prng(4);
  for (int k = 0; k < 10; ++k) {
    Points points;
    for (int i = 0; i < 6; ++i) {
      points.push_back({double(i), 0});
      points.push_back({double(prng.below(12)), 1 + 1e-300 * double(prng.below(2))});
    }
    prng.shuffle(points);
    expect_brute_force(points);
  }
}

TEST(Delaunay2, OneApexOverALineMatchesBruteForce) {
  Points points = lattice(9, 1);
  points.push_back({4, 3});
  expect_brute_force(points);
  Prng(8).shuffle(points);
  expect_brute_force(points);
}

TEST(Delaunay2, RepeatedPointsMatchBruteForce) {
  Prng prng(5);
  for (int k = 0; k < 20; ++k) {
    Points points = grid_subset(8, 4, prng);
    for (int i = 0; i < 5; ++i) points.push_back(points[prng.below(points.size())]);
    prng.shuffle(points);
    expect_brute_force(points);
  }
}

TEST(Delaunay2, ExtremeScalesMatchBruteForce) {
  Prng prng(6);
  for (int k = 0; k < 3; ++k) {
    expect_brute_force(scattered_exponents(8, -1073, -1050, prng));
    expect_brute_force(scattered_exponents(8, 1000, 1024, prng));
    expect_brute_force(scattered_exponents(9, -60, 60, prng));
    expect_brute_force(scattered_exponents(7, -1073, 1024, prng));
  }
}

TEST(Delaunay2, NeighbouringDoublesMatchBruteForce) {
  Prng prng(7);
  for (int k = 0; k < 10; ++k) {
    Points points = grid_subset(10, 5, prng);
    for (Point2& p : points) p = {1 + p.x * 0x1p-52, 3 + p.y * 0x1p-51};
    expect_brute_force(points);
  }
}

TEST(Delaunay2, MediumSetsAreDelaunay) {
  Prng prng(8);
  for (const Points& points :
       {uniform(300, prng), grid_subset(200, 16, prng), times(lattice(12, 12), 0.1),
        integer_circle(5 * 13 * 17), scattered_exponents(100, -30, 30, prng)}) {
    const Triangulation2 t = triangulate(points);
    EXPECT_TRUE(is_canonical(t));
    EXPECT_TRUE(is_locally_delaunay(t, Trust::definition));
  }
}

TEST(Delaunay2, LargeSetsAreDelaunay) {
  Prng prng(9);
  for (const Points& points :
       {uniform(10000, prng), lattice(70, 70), star_polygon(5000, 0.9, prng).points}) {
    const Triangulation2 t = triangulate(points);
    EXPECT_TRUE(is_canonical(t));
    EXPECT_TRUE(is_locally_delaunay(t, Trust::library));
  }
}

TEST(Delaunay2, PermutingThePointsRenamesTheTriangles) {
  Prng prng(10);
  for (const Points& points : {lattice(12, 9), integer_circle(5 * 13 * 17),
                               times(lattice(9, 9), 0.1), uniform(100, prng)}) {
    const Triangulation2 before = triangulate(points);
    for (int k = 0; k < 5; ++k) {
      std::vector<std::size_t> name;
      const Triangulation2 after = triangulate(shuffled({points, {}}, prng, &name).points);
      std::vector<PlaneTriangleVertices> renamed;
      for (PlaneTriangleVertices v : before.triangles) {
        for (PlaneVertexId& u : v) u = PlaneVertexId(name[u.index()]);
        std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
        renamed.push_back(v);
      }
      std::sort(renamed.begin(), renamed.end());
      EXPECT_EQ(after.triangles.raw(), renamed);
    }
  }
}

TEST(Delaunay2, ScalingByAPowerOfTwoChangesNothing) {
  Prng prng(11);
  for (const Points& points : {lattice(8, 8), uniform(200, prng)}) {
    const Triangulation2 t = triangulate(points);
    for (const double factor : {0x1p-1000, 0x1p-300, 0x1p3, 0x1p400, 0x1p1000}) {
      EXPECT_EQ(triangulate(times(points, factor)).triangles, t.triangles);
    }
  }
}

TEST(Delaunay2, ASquareIsCutByTheDiagonalOfItsMiddleCorners) {
  // Of four cocircular points the last in canonical order is raised most: it is cut off.
  const Points square{{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  EXPECT_EQ(
      triangulate(square).triangles.raw(),
      (std::vector<PlaneTriangleVertices>{{PlaneVertexId(0), PlaneVertexId(2), PlaneVertexId(1)},
                                          {PlaneVertexId(1), PlaneVertexId(2), PlaneVertexId(3)}}));
}

}  // namespace
}  // namespace tetloft::test
