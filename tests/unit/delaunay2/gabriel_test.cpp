// Segments whose diametral circles must be empty.
#include <gtest/gtest.h>

#include "plane_oracles.hpp"

namespace tetloft::test {
namespace {

Conforming2 expect_gabriel(const Graph& graph) {
  Conforming2 c = conform(graph, all_gabriel(graph));
  EXPECT_TRUE(respects(c, graph));
  EXPECT_TRUE(is_canonical(c.triangulation));
  EXPECT_TRUE(is_locally_delaunay(c.triangulation, Trust::library));
  EXPECT_TRUE(is_gabriel(c, graph));
  return c;
}

TEST(Gabriel, AVertexOnTheCircleCounts) {
  const Graph graph{{{0, 0}, {2, 0}, {1, 1}, {1, 5}}, {{PlaneVertexId(0), PlaneVertexId(1)}}};
  EXPECT_TRUE(conform(graph).split.empty());
  EXPECT_EQ(inserted(expect_gabriel(graph), graph), (Points{{1, 0}}));
}

TEST(Gabriel, AVertexOutsideTheCircleDoesNot) {
  const Graph graph{{{0, 0}, {2, 0}, {1, 1.0000001}, {1, 5}},
                    {{PlaneVertexId(0), PlaneVertexId(1)}}};
  EXPECT_TRUE(expect_gabriel(graph).split.empty());
}

TEST(Gabriel, OnlyFlaggedSegmentsAreRefined) {
  const Graph graph{{{0, 0}, {2, 0}, {1, 0.5}, {10, 0}, {12, 0}, {11, 0.5}},
                    {{PlaneVertexId(0), PlaneVertexId(1)}, {PlaneVertexId(3), PlaneVertexId(4)}}};
  ConformingOptions options;
  options.gabriel = {false, true};
  const Conforming2 c = conform(graph, options);
  EXPECT_EQ(c.chains[0].size(), 2U);
  EXPECT_GT(c.chains[1].size(), 2U);
}

TEST(Gabriel, LatticePolygons) {
  Prng prng(1);
  for (int k = 0; k < 10; ++k) expect_gabriel(skyline(3 + int(prng.below(20)), 8, prng));
}

TEST(Gabriel, StarPolygons) {
  Prng prng(2);
  for (const double low : {0.9, 0.3}) {
    for (const std::size_t n : {5U, 20U, 50U}) expect_gabriel(star_polygon(n, low, prng));
  }
}

TEST(Gabriel, FansOfSegmentsAtOneVertex) {
  Prng prng(3);
  for (const std::size_t n : {3U, 10U, 25U}) {
    expect_gabriel(fan(n, 6.28, prng));
    expect_gabriel(fan(n, 1, prng));
  }
}

TEST(Gabriel, AcuteCornersNeedShellsOnly) {
  // Side by side from one corner: both choose the same radii, so the number of splits grows
  // with the logarithm of the angle, not with its inverse.
  for (const double angle : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Graph graph{{{0, 0}, {0.93, 0}, {0.87, 0.87 * angle}},
                      {{PlaneVertexId(0), PlaneVertexId(1)}, {PlaneVertexId(0), PlaneVertexId(2)}}};
    EXPECT_LT(expect_gabriel(graph).split.size(), 120U) << angle;
  }
}

TEST(Gabriel, RightAnglesNeedNoSplit) {
  const Graph graph{{{0, 0}, {1, 0}, {0, 1}},
                    {{PlaneVertexId(0), PlaneVertexId(1)}, {PlaneVertexId(0), PlaneVertexId(2)}}};
  EXPECT_TRUE(expect_gabriel(graph).split.empty());
}

}  // namespace
}  // namespace tetloft::test
