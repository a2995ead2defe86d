// Points in general position, input errors, dimensions and duplicates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support.hpp"

namespace tetloft::test {
namespace {

TEST(Delaunay3, OneTetOfFourPoints) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Delaunay3 d = triangulate(points);
  EXPECT_EQ(d.dimension, 3);
  EXPECT_EQ(d.duplicates, 0U);
  // Canonical order is by (z, x, y): 0, 2, 1, 3; that order is negative.
  EXPECT_EQ(tets_of(d.mesh),
            (std::vector<TetVertices>{{VertexId(0), VertexId(2), VertexId(3), VertexId(1)}}));
  EXPECT_EQ(d.mesh.boundary().size(), 4U);
}

TEST(Delaunay3, RandomSetsEqualBruteForce) {
  Prng prng(1);
  for (std::size_t n = 4; n <= 16; ++n) {
    for (int round = 0; round < 6; ++round) {
      SCOPED_TRACE(testing::Message() << "n " << n << " round " << round);
      expect_brute_force(uniform(n, prng));
    }
  }
}

TEST(Delaunay3, MediumRandomSetFillsItsHull) {
  Prng prng(2);
  expect_delaunay(uniform(700, prng));
}

TEST(Delaunay3, TwentyThousandPointsAreDelaunay) {
  Prng prng(3);
  const Points points = uniform(20000, prng);
  const Delaunay3 d = triangulate(points);
  EXPECT_TRUE(is_canonical(d, points));
  EXPECT_TRUE(is_locally_delaunay(d, points));
  EXPECT_TRUE(uses_all_points(d));
  EXPECT_TRUE(d.mesh.validate().empty());
  // A tetrahedrisation of a ball has t = e − n + n_hull − 3 …, about 6.7 for each point.
  EXPECT_GT(d.mesh.tet_count(), 6U * points.size());
  EXPECT_LT(d.mesh.tet_count(), 7U * points.size());
}

// So many that the order is sorted by several threads, and the mesh made in rounds, after which
// slots are given back.
TEST(Delaunay3, SixtyThousandPointsAreTheSameOnSeveralThreads) {
  Prng prng(5);
  const Points points = uniform(60000, prng);
  const Delaunay3 alone = delaunay3(points, {.execution = {.threads = 1}}).value();
  EXPECT_TRUE(is_canonical(alone, points));
  EXPECT_TRUE(is_locally_delaunay(alone, points));
  EXPECT_TRUE(uses_all_points(alone));
  EXPECT_TRUE(alone.mesh.validate().empty());
  const Delaunay3 several = delaunay3(points, {.execution = {.threads = 3}}).value();
  EXPECT_TRUE(std::ranges::equal(several.mesh.tets(), alone.mesh.tets()));
  EXPECT_TRUE(std::ranges::equal(several.mesh.opposites(), alone.mesh.opposites()));
}

// A point far below all others sees many facets of their hull.
TEST(Delaunay3, ManyTetsOfTheLowestVertexAreInOrder) {
  Prng prng(5);
  Points points;
  for (int i = 0; i < 400; ++i) {
    const double x = prng.unit() - 0.5, y = prng.unit() - 0.5;
    points.push_back({x, y, x * x + y * y});
  }
  points.push_back({0, 0, -100});
  expect_delaunay(points);
  const Delaunay3 d = triangulate(points);
  std::size_t of_lowest = 0;
  for (const TetVertices& tet : d.mesh.tets()) of_lowest += tet[0] == VertexId(400) ? 1U : 0U;
  EXPECT_GT(of_lowest, 300U);
}

TEST(Delaunay3, ClusteredPointsAreDelaunay) {
  Prng prng(4);
  Points points;
  for (int c = 0; c < 8; ++c) {
    const Point3 centre{prng.between(-100, 100), prng.between(-100, 100), prng.between(-100, 100)};
    const double radius = std::ldexp(1.0, -6 * c);
    for (int i = 0; i < 60; ++i) {
      points.push_back({centre.x + radius * prng.unit(), centre.y + radius * prng.unit(),
                        centre.z + radius * prng.unit()});
    }
  }
  expect_delaunay(points);
}

TEST(Delaunay3, DimensionIsThatOfTheAffineHull) {
  const auto dimension = [](const Points& points) {
    const Delaunay3 d = triangulate(points);
    if (d.dimension < 3) {
      EXPECT_EQ(d.mesh.tet_count(), 0U);
    }
    EXPECT_EQ(d.mesh.vertex_count(), points.size());
    return d.dimension;
  };
  EXPECT_EQ(dimension({}), -1);
  EXPECT_EQ(dimension({{1, 2, 3}}), 0);
  EXPECT_EQ(dimension({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), 0);
  EXPECT_EQ(dimension({{1, 2, 3}, {4, 5, 6}}), 1);
  EXPECT_EQ(dimension({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {5, 10, 15}, {-3, -6, -9}}), 1);
  EXPECT_EQ(dimension({{0, 0, 5}, {0, 1, 5}, {0, 7, 5}, {0, -2, 5}, {0, -2, 5}}), 1);
  EXPECT_EQ(dimension({{0, 0, 0}, {1, 2, 3}, {2, 4, 7}}), 2);
  EXPECT_EQ(dimension({{0, 0, 5}, {1, 2, 5}, {2, 4, 5}, {3, 3, 5}, {9, 9, 5}}), 2);
  // x + y + z = 0.
  EXPECT_EQ(dimension({{0, 0, 0}, {1, -1, 0}, {1, 0, -1}, {0, 1, -1}, {3, -2, -1}}), 2);
  EXPECT_EQ(dimension({{0, 0, 5}, {1, 2, 5}, {2, 4, 5}, {3, 3, 5}, {9, 9, 5 + 0x1p-50}}), 3);
}

TEST(Delaunay3, DimensionIsExactWhereRoundingWouldFlatten) {
  // A last bit off the line, and off the plane.
  const double up = std::nextafter(1.0, 2.0);
  EXPECT_EQ(triangulate(Points{{0, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, up}}).dimension, 2);
  const Points tet{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, std::nextafter(2.0, 3.0)}};
  EXPECT_EQ(triangulate(tet).dimension, 3);
  expect_brute_force(tet);
}

TEST(Delaunay3, DuplicatesPointToTheLowestIndex) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0},      {1, 0, 0},
                      {0, 0, 1}, {0, 0, 0}, {1, 1, 1}, {-0.0, 0, -0.0}};
  const Delaunay3 d = triangulate(points);
  EXPECT_EQ(d.duplicates, 4U);
  const std::vector<std::uint32_t> expected{0, 1, 0, 3, 1, 5, 0, 7, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(d.representative[VertexId(i)].value(), expected[i]);
  }
  expect_brute_force(points);
}

TEST(Delaunay3, NonFiniteCoordinatesAreRefusedNamingTheVertex) {
  const double bad[] = {std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  for (const double value : bad) {
    for (const Point3& p : {Point3{value, 0, 0}, Point3{0, value, 0}, Point3{0, 0, value}}) {
      Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
      points[3] = p;
      const Result<Delaunay3> result = delaunay3(points);
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
      EXPECT_EQ(result.error().where.vertex, std::size_t{3});
    }
  }
}

}  // namespace
}  // namespace tetloft::test
