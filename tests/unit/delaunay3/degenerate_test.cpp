// Degenerate point sets: lattices, planes, circles, spheres, lines, extreme magnitudes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support.hpp"

namespace tetloft::test {
namespace {

TEST(Delaunay3Degenerate, GridSubsetsEqualBruteForce) {
  Prng prng(11);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    const std::size_t n = 6 + static_cast<std::size_t>(prng.below(9));
    const int side = 2 + static_cast<int>(prng.below(2));
    Points points = grid_subset(n, side, prng);
    if (triangulate(points).dimension < 3) continue;
    expect_brute_force(points);
  }
}

TEST(Delaunay3Degenerate, LatticeCubeEqualsBruteForce) { expect_brute_force(lattice(3, 3, 2)); }

TEST(Delaunay3Degenerate, LatticeFillsItsBox) {
  const Points points = lattice(7, 6, 5);
  expect_delaunay(points);
  EXPECT_EQ(six_volumes(triangulate(points), points), 6.0 * 6 * 5 * 4);
}

TEST(Delaunay3Degenerate, LatticeOfUnevenSpacingFillsItsBox) {
  Points points = lattice(6, 6, 6);
  for (Point3& p : points) p = {p.x * 0.1, p.y * 3, p.z * 1024};
  expect_delaunay(points);
}

TEST(Delaunay3Degenerate, EqualPolygonsOnTwoPlanesEqualBruteForce) {
  // Two regular octagons of integer coordinates are cocircular and, together, cospherical.
  const double ring[8][2] = {{1, 3},   {3, 1},   {3, -1}, {1, -3},
                             {-1, -3}, {-3, -1}, {-3, 1}, {-1, 3}};
  for (const double height : {1.0, 0x1p-40, 1e6}) {
    Points points;
    for (const double z : {0.0, height}) {
      for (const auto& p : ring) points.push_back({p[0], p[1], z});
    }
    expect_brute_force(points);
  }
}

TEST(Delaunay3Degenerate, PixelGridsOnTwoPlanesFillTheSlab) {
  Points points = lattice(12, 11, 2);
  for (Point3& p : points) p.z *= 5;
  expect_delaunay(points);
  EXPECT_EQ(six_volumes(triangulate(points), points), 6.0 * 11 * 10 * 5);
}

TEST(Delaunay3Degenerate, ShiftedGridsOnTwoPlanesFillTheSlab) {
  Points points = lattice(9, 9, 2);
  for (Point3& p : points) {
    if (p.z > 0) p = {p.x + 0.5, p.y + 0.25, p.z};
  }
  expect_delaunay(points);
}

TEST(Delaunay3Degenerate, CosphericalPointsEqualBruteForce) {
  const Points sphere = integer_sphere(3);  // 30 points of squared distance 9
  ASSERT_EQ(sphere.size(), 30U);
  expect_delaunay(sphere);
  Prng prng(12);
  for (int round = 0; round < 10; ++round) {
    Points subset = sphere;
    prng.shuffle(subset);
    subset.resize(13);
    if (round % 2 == 0) subset.push_back({0, 0, 0});
    expect_brute_force(subset);
  }
}

TEST(Delaunay3Degenerate, LargeCosphericalSetIsDelaunay) { expect_delaunay(integer_sphere(27)); }

TEST(Delaunay3Degenerate, CocircularPointsInTiltedPlanesEqualBruteForce) {
  // Regular hexagons in x + y + z = k, an apex on each side.
  Points points;
  const double hexagon[6][3] = {{1, -1, 0}, {1, 0, -1}, {0, 1, -1},
                                {-1, 1, 0}, {-1, 0, 1}, {0, -1, 1}};
  for (const auto& p : hexagon) points.push_back({p[0], p[1], p[2]});
  points.push_back({0, 0, 0});
  points.push_back({1, 1, 1});
  points.push_back({-1, -1, -1});
  expect_brute_force(points);
  for (const auto& p : hexagon) points.push_back({p[0] + 2, p[1] + 2, p[2] + 2});
  expect_brute_force(points);
}

TEST(Delaunay3Degenerate, PointsOnLinesEqualBruteForce) {
  // Two skew lines: every tet has an edge on each, n m tets in all.
  Points points;
  for (int i = 0; i < 6; ++i) points.push_back({1.0 * i, 0, 0});
  for (int i = 0; i < 7; ++i) points.push_back({2, 1.0 * i - 3, 1});
  expect_brute_force(points);
  EXPECT_EQ(triangulate(points).mesh.tet_count(), 5U * 6U);
  // A line and one triangle beside it.
  points = {{0, 5, 0}, {0, 6, 1}, {1, 5, 3}};
  for (int i = 0; i < 9; ++i) points.push_back({1.0 * i, 1.0 * i, 1.0 * i});
  expect_brute_force(points);
}

TEST(Delaunay3Degenerate, NearlyAllPointsInOnePlane) {
  Points points = lattice(8, 8, 1);
  points.push_back({3, 3, 1});
  expect_delaunay(points);
  points.push_back({4, 4, -1});
  expect_delaunay(points);
}

TEST(Delaunay3Degenerate, PointsOnManyPlanesWithDuplicates) {
  Prng prng(13);
  Points points;
  for (int i = 0; i < 600; ++i) {
    points.push_back({static_cast<double>(prng.below(7)), static_cast<double>(prng.below(6)),
                      static_cast<double>(prng.below(5))});
  }
  expect_delaunay(points);
}

TEST(Delaunay3Degenerate, HugeAndTinyCoordinatesEqualBruteForce) {
  Prng prng(14);
  for (const double scale : {0x1p1023, 0x1p600, 0x1p-600, 0x1p-1050, 0x1p-1070}) {
    SCOPED_TRACE(testing::Message() << "scale " << scale);
    Points points = grid_subset(11, 3, prng);
    for (Point3& p : points) p = {(p.x - 1) * scale, (p.y - 1) * scale, (p.z - 1) * scale};
    if (triangulate(points).dimension < 3) continue;
    expect_brute_force(points);
  }
  const double top = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  expect_brute_force(Points{{-top, -top, -top},
                            {top, -top, -top},
                            {-top, top, -top},
                            {-top, -top, top},
                            {top, top, top},
                            {0, 0, 0},
                            {least, 0, 0},
                            {0, least, 0},
                            {0, 0, least},
                            {1, 1, 1},
                            {-1, 1e300, 1e-300}});
}

TEST(Delaunay3Degenerate, MixedMagnitudesEqualBruteForce) {
  Prng prng(15);
  for (int round = 0; round < 10; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    Points points(11);
    const auto draw = [&] {
      const double sign = prng.chance(0.5) ? 1.0 : -1.0;
      return sign * std::ldexp(1.0 + prng.unit(), static_cast<int>(prng.below(400)) - 200);
    };
    for (Point3& p : points) p = {draw(), draw(), draw()};
    expect_brute_force(points);
  }
}

}  // namespace
}  // namespace tetloft::test
