#include "delaunay2/incremental.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "planar_sets.hpp"

namespace tetloft::internal::delaunay2_detail {
namespace {

const SiteId v1{1}, v2{2}, v3{3};

Incremental2 unit_triangle() { return Incremental2({0, 0}, {8, 0}, {0, 8}, 10); }

TEST(Incremental2, StartsWithOneRealTriangle) {
  const Incremental2 plane = unit_triangle();
  EXPECT_EQ(plane.vertex_count(), 4U);
  ASSERT_EQ(plane.triangle_count(), 4U);
  EXPECT_FALSE(plane.is_ghost(TriangleId(0)));
  for (int t = 1; t < 4; ++t) EXPECT_TRUE(plane.is_ghost(TriangleId(t)));
}

TEST(Incremental2, OppositeIsAnInvolutionThatReversesEdges) {
  Incremental2 plane = unit_triangle();
  Prng prng(1);
  for (const Point2& p : test::grid_subset(200, 20, prng)) {
    plane.insert(p, v1);
    ASSERT_EQ(plane.triangle_count(), 2 * (plane.vertex_count() - 1) - 2);
  }
  for (std::uint32_t i = 0; i < 3 * plane.triangle_count(); ++i) {
    const HalfEdgeId h = Incremental2::half_edge(TriangleId(i / 3), i % 3);
    ASSERT_EQ(plane.opposite(plane.opposite(h)), h);
    ASSERT_EQ(plane.origin(plane.opposite(h)), plane.destination(h));
    ASSERT_EQ(plane.find_edge(plane.origin(h), plane.destination(h)), h);
  }
}

TEST(Incremental2, InsertingAPointTwiceReturnsItsVertex) {
  Incremental2 plane = unit_triangle();
  const SiteId inside = plane.insert({1, 1}, v1);
  const SiteId on_hull = plane.insert({4, 0}, v3);
  const SiteId outside = plane.insert({9, 9}, v2);
  EXPECT_EQ(plane.vertex_count(), 7U);
  EXPECT_EQ(plane.insert({1, 1}, v2), inside);
  EXPECT_EQ(plane.insert({4, 0}, v2), on_hull);
  EXPECT_EQ(plane.insert({9, 9}, v1), outside);
  EXPECT_EQ(plane.insert({0, 8}, v2), v3);
  EXPECT_EQ(plane.vertex_count(), 7U);
}

TEST(Incremental2, PointsOnTheLineOfAHullEdgeExtendOrSplitIt) {
  Incremental2 plane = unit_triangle();
  const SiteId beyond = plane.insert({12, 0}, v1);
  EXPECT_TRUE(plane.find_edge(v2, beyond).valid());
  EXPECT_TRUE(plane.find_edge(v1, v2).valid());
  const SiteId between = plane.insert({3, 0}, v1);
  EXPECT_FALSE(plane.find_edge(v1, v2).valid());
  EXPECT_TRUE(plane.find_edge(v1, between).valid());
}

TEST(Incremental2, EdgesThatDoNotExistAreNotFound) {
  Incremental2 plane = unit_triangle();
  const SiteId far = plane.insert({8, 8}, v1);
  EXPECT_FALSE(plane.find_edge(v1, far).valid() && plane.find_edge(v2, v3).valid());
  EXPECT_TRUE(plane.find_edge(v1, far).valid() || plane.find_edge(v2, v3).valid());
}

TEST(Incremental2, InsertionReportsTheLabelsOfEdgesItTouches) {
  Incremental2 plane = unit_triangle();
  plane.set_label(plane.find_edge(v1, v2), LabelId(12));
  plane.set_label(plane.find_edge(v3, v2), LabelId(23));
  EXPECT_TRUE(plane.take_touched().empty());
  // In conflict with the triangle, not with the ghost triangles: all its edges stay.
  const SiteId inside = plane.insert({2, 2}, v1);
  std::vector<LabelId> touched = plane.take_touched();
  std::sort(touched.begin(), touched.end());
  EXPECT_EQ(touched, (std::vector<LabelId>{LabelId(12), LabelId(23)}));
  EXPECT_TRUE(plane.take_touched().empty());
  // In conflict with the ghost triangle at v1 v2 only, and then with that at v3 v1 only.
  plane.insert({4, -100}, v1);
  EXPECT_EQ(plane.take_touched(), std::vector<LabelId>{LabelId(12)});
  plane.insert({-100, 4}, inside);
  EXPECT_TRUE(plane.take_touched().empty());
}

TEST(Incremental2, LabelsSurviveWhileTheirEdgeDoes) {
  Incremental2 plane = unit_triangle();
  plane.set_label(plane.find_edge(v1, v2), LabelId(5));
  plane.insert({4, 1}, v1);
  plane.insert({4, 0.5}, v1);
  EXPECT_TRUE(plane.find_edge(v1, v2).valid());
  EXPECT_EQ(plane.take_touched(), (std::vector<LabelId>{LabelId(5), LabelId(5)}));
  plane.insert({4, 0}, v1);
  EXPECT_FALSE(plane.find_edge(v1, v2).valid());
  EXPECT_FALSE(plane.take_touched().empty());
  plane.insert({3, 0.25}, v1);
  EXPECT_TRUE(plane.take_touched().empty());
}

}  // namespace
}  // namespace tetloft::internal::delaunay2_detail
