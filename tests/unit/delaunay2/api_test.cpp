// What delaunay2 and conforming_delaunay2 refuse, and what they do without triangles.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "plane_oracles.hpp"

namespace tetloft::test {
namespace {

Segment segment(int a, int b) { return {PlaneVertexId(a), PlaneVertexId(b)}; }

TEST(Delaunay2Api, FewerThanThreePointsMakeNoTriangles) {
  for (std::size_t n = 0; n < 3; ++n) {
    const Triangulation2 t = triangulate(lattice(1, int(n)));
    EXPECT_EQ(t.points.size(), n);
    EXPECT_TRUE(t.triangles.empty());
    EXPECT_TRUE(t.neighbours.empty());
  }
}

TEST(Delaunay2Api, CollinearPointsMakeNoTriangles) {
  Points diagonal;
  for (int i = 0; i < 100; ++i) diagonal.push_back({0.25 * i, 0.75 * i});
  EXPECT_TRUE(triangulate(diagonal).triangles.empty());
  EXPECT_TRUE(triangulate(lattice(50, 1)).triangles.empty());
  EXPECT_TRUE(triangulate(Points(10, Point2{1, 2})).triangles.empty());
}

TEST(Delaunay2Api, NonFiniteCoordinatesAreRefusedNamingTheVertex) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    Points points = lattice(3, 3);
    points[5].y = bad;
    const Result<Triangulation2> plain = delaunay2(points);
    ASSERT_FALSE(plain.ok());
    EXPECT_EQ(plain.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(plain.error().where.vertex, 5U);
    const Result<Conforming2> conforming = conforming_delaunay2(points, {});
    ASSERT_FALSE(conforming.ok());
    EXPECT_EQ(conforming.error().where.vertex, 5U);
  }
}

TEST(Delaunay2Api, SignedZerosAreOnePoint) {
  const Points points{{0.0, 0.0}, {1, 0}, {0, 1}, {-0.0, 0.0}, {-0.0, -0.0}};
  const Triangulation2 t = triangulate(points);
  EXPECT_EQ(
      t.triangles.raw(),
      (std::vector<PlaneTriangleVertices>{{PlaneVertexId(0), PlaneVertexId(1), PlaneVertexId(2)}}));
}

TEST(ConformingApi, RepeatedPointsAreRefusedNamingTheSecond) {
  for (Points points :
       {Points{{0, 0}, {1, 0}, {0, 1}, {1, 0}}, Points{{0, 0}, {1, 0}, {2, 0}, {1, 0}}}) {
    const Result<Conforming2> result = conforming_delaunay2(points, {});
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(result.error().where.vertex, 3U);
  }
}

TEST(ConformingApi, BadSegmentsAreRefused) {
  const Points points = lattice(2, 2);
  const std::vector<std::vector<Segment>> bad{{segment(0, 4)},
                                              {segment(2, 2)},
                                              {segment(0, 1), segment(0, 1)},
                                              {segment(0, 1), segment(1, 0)}};
  for (const std::vector<Segment>& segments : bad) {
    const Result<Conforming2> result = conforming_delaunay2(points, segments);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
  }
}

TEST(ConformingApi, FlagsOfTheWrongNumberAreRefused) {
  ConformingOptions options;
  options.gabriel = {true, false};
  const Result<Conforming2> result =
      conforming_delaunay2(lattice(2, 2), std::vector{segment(0, 1)}, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::usage);
}

TEST(ConformingApi, CoordinatesThatLengthsOverflowAreRefused) {
  const Points points = times(lattice(2, 2), 0x1p1001);
  const Result<Conforming2> result = conforming_delaunay2(points, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
  EXPECT_TRUE(conforming_delaunay2(times(lattice(2, 2), 0x1p1000), {}).ok());
}

TEST(ConformingApi, SegmentsOfCollinearPointsAreTheirOwnChains) {
  const Points points{{3, 3}, {0, 0}, {1, 1}, {2, 2}};
  const std::vector<Segment> segments{segment(0, 3), segment(1, 2)};
  const Result<Conforming2> result = conforming_delaunay2(points, segments);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->triangulation.triangles.empty());
  EXPECT_EQ(result->triangulation.points.raw(), points);
  EXPECT_EQ(result->chains[0], (std::vector<PlaneVertexId>{PlaneVertexId(0), PlaneVertexId(3)}));
  EXPECT_EQ(result->chains[1], (std::vector<PlaneVertexId>{PlaneVertexId(1), PlaneVertexId(2)}));
  const Result<Conforming2> through = conforming_delaunay2(points, std::vector{segment(2, 0)});
  ASSERT_FALSE(through.ok());
  EXPECT_EQ(through.error().where.vertex, 3U);
}

TEST(ConformingApi, EmptyInputHasAnEmptyResult) {
  const Result<Conforming2> result = conforming_delaunay2({}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->triangulation.points.empty());
}

TEST(ConformingApi, NoRoomIsUnrepresentableNamingThePoint) {
  // The vertical segment passes between (1, 1) and its neighbour to the right: no double does.
  const double right = std::nextafter(1.0, 2.0);
  const Points points{{1, 0}, {right, 2}, {1, 1}, {right, 1}};
  const Result<Conforming2> result = conforming_delaunay2(points, std::vector{segment(0, 1)});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
  EXPECT_EQ(result.error().where.vertex, 0U);
  ASSERT_TRUE(result.error().where.point.has_value());
  EXPECT_NEAR(result.error().where.point->y, 1, 1e-15);
}

TEST(ConformingApi, CrossingSegmentsEndAsUnrepresentable) {
  const Points points{{0, 0}, {3, 1}, {1, -1}, {1.5, 2}};
  const std::vector<Segment> segments{segment(0, 1), segment(2, 3)};
  const Result<Conforming2> result = conforming_delaunay2(points, segments);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
}

TEST(ConformingApi, TheBoundOnInsertedPointsHolds) {
  Prng prng(5);
  const Graph graph = skyline(30, 40, prng);
  const std::size_t needed = conform(graph).split.size();
  ASSERT_GT(needed, 10U);
  ConformingOptions options;
  options.most_inserted = needed;
  EXPECT_TRUE(conforming_delaunay2(graph.points, graph.segments, options).ok());
  options.most_inserted = 1;
  const Result<Conforming2> result = conforming_delaunay2(graph.points, graph.segments, options);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::work_limit);
}

}  // namespace
}  // namespace tetloft::test
