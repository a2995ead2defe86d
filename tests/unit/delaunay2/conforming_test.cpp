// Conforming triangulations: segments are chains of edges of the Delaunay triangulation.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "plane_oracles.hpp"

namespace tetloft::test {
namespace {

Conforming2 expect_conforming(const Graph& graph, Trust trust = Trust::library) {
  Conforming2 c = conform(graph);
  EXPECT_TRUE(respects(c, graph));
  EXPECT_TRUE(is_canonical(c.triangulation));
  EXPECT_TRUE(is_locally_delaunay(c.triangulation, trust));
  return c;
}

Graph bar_among(Points others) {
  Graph graph{{{0, 0}, {1, 0}}, {{PlaneVertexId(0), PlaneVertexId(1)}}};
  graph.points.insert(graph.points.end(), others.begin(), others.end());
  return graph;
}

TEST(Conforming, SegmentsThatAreEdgesAreNotSplit) {
  Prng prng(1);
  Graph graph{uniform(300, prng), {}};
  const Triangulation2 t = triangulate(graph.points);
  for (const PlaneTriangleVertices& v : t.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[k] < v[(k + 1) % 3]) graph.segments.push_back({v[k], v[(k + 1) % 3]});
    }
  }
  const Conforming2 c = expect_conforming(graph);
  EXPECT_TRUE(c.split.empty());
  EXPECT_EQ(c.triangulation.triangles, t.triangles);
}

TEST(Conforming, WithoutSegmentsIsThePlainTriangulation) {
  Prng prng(2);
  const Points points = grid_subset(100, 12, prng);
  EXPECT_EQ(conform({points, {}}).triangulation.triangles, triangulate(points).triangles);
}

TEST(Conforming, AMissingSegmentIsSplitAtItsMidpoint) {
  const Graph graph = bar_among({{0.5, 0.1}, {0.5, -0.1}});
  const Conforming2 c = expect_conforming(graph, Trust::definition);
  EXPECT_EQ(inserted(c, graph), (Points{{0.5, 0}}));
  EXPECT_EQ(c.chains[0],
            (std::vector<PlaneVertexId>{PlaneVertexId(0), PlaneVertexId(4), PlaneVertexId(1)}));
}

TEST(Conforming, AtAnAcuteCornerTheFirstSplitIsAPowerOfTwoAway) {
  Graph graph = bar_among({{0.7, 0.1}, {0.4, 0.05}, {0.4, -0.05}});
  graph.points[1].x = 0.9;
  graph.segments.push_back({PlaneVertexId(0), PlaneVertexId(2)});
  graph.points[3] = {0.5, 0.02};
  graph.points[4] = {0.5, -0.02};
  const Conforming2 c = expect_conforming(graph, Trust::definition);
  ASSERT_GE(c.chains[0].size(), 3U);
  bool has_half = false;
  for (const PlaneVertexId v : c.chains[0]) has_half |= c.triangulation.points[v] == Point2{0.5, 0};
  EXPECT_TRUE(has_half);
}

TEST(Conforming, ASegmentWithTwoAcuteEndsIsFirstSplitInTheMiddle) {
  // A thin Z: the bar has an acute corner at both ends.
  Graph graph{{{0, 0}, {0.9, 0}, {0.6, 0.2}, {0.3, -0.2}, {0.45, 0.05}, {0.45, -0.05}},
              {{PlaneVertexId(0), PlaneVertexId(1)},
               {PlaneVertexId(0), PlaneVertexId(2)},
               {PlaneVertexId(1), PlaneVertexId(3)}}};
  const Conforming2 c = expect_conforming(graph, Trust::definition);
  bool has_middle = false;
  for (const PlaneVertexId v : c.chains[0])
    has_middle |= c.triangulation.points[v] == Point2{0.45, 0};
  EXPECT_TRUE(has_middle);
}

TEST(Conforming, LatticePolygons) {
  Prng prng(3);
  for (int k = 0; k < 20; ++k) {
    expect_conforming(skyline(3 + int(prng.below(40)), 2 + int(prng.below(20)), prng));
  }
  Graph scaled = skyline(40, 12, prng);
  scaled.points = times(scaled.points, 0.1);
  expect_conforming(scaled);
}

TEST(Conforming, StarPolygons) {
  Prng prng(4);
  for (const double low : {0.95, 0.5, 0.1}) {
    for (const std::size_t n : {5U, 20U, 100U}) expect_conforming(star_polygon(n, low, prng));
  }
}

TEST(Conforming, SmallPolygonsByDefinition) {
  Prng prng(5);
  for (int k = 0; k < 10; ++k) {
    expect_conforming(skyline(6, 6, prng), Trust::definition);
    expect_conforming(star_polygon(12, 0.2, prng), Trust::definition);
  }
}

TEST(Conforming, FansOfSegmentsAtOneVertex) {
  Prng prng(6);
  for (const std::size_t n : {3U, 10U, 100U}) {
    expect_conforming(fan(n, 6.28, prng));
    expect_conforming(fan(n, 1, prng));
  }
}

TEST(Conforming, SliversOfDecreasingAngle) {
  Prng prng(7);
  for (const double angle : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Conforming2 c = expect_conforming(fan(3, 3 * angle, prng));
    EXPECT_LT(c.split.size(), 400U) << angle;
  }
}

TEST(Conforming, TwoSegmentsSideBySideNeedFewSplits) {
  for (const double gap : {1e-2, 1e-5, 1e-9}) {
    Graph graph{{{0, 0}, {1, 0}, {0.3, gap}, {1.3, gap}, {0.2, -gap}, {1.7, -gap}},
                {{PlaneVertexId(0), PlaneVertexId(1)},
                 {PlaneVertexId(2), PlaneVertexId(3)},
                 {PlaneVertexId(4), PlaneVertexId(5)}}};
    const Conforming2 c = expect_conforming(graph);
    EXPECT_LT(c.split.size(), 400U) << gap;
  }
}

TEST(Conforming, SpacingThatVariesByAMillion) {
  // Around a wavy circle in steps that grow and shrink by √2 between 1e-7 and 1e-1.
  Prng prng(8);
  Points points;
  double angle = 0;
  double step = 1e-1;
  double factor = std::sqrt(0.5);
  double least = step;
  while (angle < 6.28) {
    const double radius = 10 + std::sin(5 * angle) + 0.3 * step * prng.unit();
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    if (step * factor < 1e-7 || step * factor > 0.1) factor = 1 / factor;
    step *= factor;
    least = std::min(least, step);
    angle += step;
  }
  ASSERT_GT(points.size(), 300U);
  ASSERT_LT(least, 2e-7);
  expect_conforming(polygon(std::move(points)));
}

TEST(Conforming, PolygonsOfTwentyThousandVertices) {
  Prng prng(9);
  Points points;
  for (int i = 0; i < 20000; ++i) {
    const double a = 6.283185307179586 * i / 20000;
    const double radius = 100 + 30 * std::sin(7 * a) + 10 * std::sin(31 * a);
    points.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  const Graph smooth = polygon(std::move(points));
  const Graph rough = star_polygon(20000, 0.999, prng);
  for (const Graph& graph : {smooth, rough}) {
    const Conforming2 c = conform(graph);
    EXPECT_TRUE(is_locally_delaunay(c.triangulation, Trust::library));
    std::size_t vertices = 0;
    for (const std::vector<PlaneVertexId>& chain : c.chains) vertices += chain.size() - 2;
    EXPECT_EQ(vertices, c.split.size());
  }
}

TEST(Conforming, HugeAndTinyCoordinates) {
  Prng prng(10);
  const Graph graph = star_polygon(30, 0.2, prng);
  const Points reference = inserted(conform(graph), graph);
  ASSERT_FALSE(reference.empty());
  for (const double factor : {0x1p-900, 0x1p-400, 0x1p400, 0x1p1000}) {
    Graph scaled{times(graph.points, factor), graph.segments};
    EXPECT_EQ(inserted(conform(scaled), scaled), times(reference, factor)) << factor;
  }
}

TEST(Conforming, InsertedPointsDoNotDependOnTheOrderOfTheInput) {
  Prng prng(11);
  const Graph graphs[] = {
      skyline(30, 20, prng), star_polygon(40, 0.1, prng), fan(20, 1, prng),
      fan(30, 6.28, prng) + Graph{{{2, 2}, {3, 3}}, {{PlaneVertexId(0), PlaneVertexId(1)}}}};
  for (const Graph& graph : graphs) {
    for (const bool gabriel : {false, true}) {
      const auto conform_all = [gabriel](const Graph& g) {
        return conform(g, gabriel ? all_gabriel(g) : ConformingOptions{});
      };
      const Conforming2 before = conform_all(graph);
      ASSERT_GT(before.split.size(), 0U);
      for (int k = 0; k < 5; ++k) {
        const Graph other = shuffled(graph, prng);
        const Conforming2 after = conform_all(other);
        EXPECT_EQ(inserted(after, other), inserted(before, graph));
        // They are numbered alike, too.
        EXPECT_TRUE(
            std::equal(after.triangulation.points.begin() + std::ptrdiff_t(other.points.size()),
                       after.triangulation.points.end(),
                       before.triangulation.points.begin() + std::ptrdiff_t(graph.points.size())));
      }
    }
  }
}

}  // namespace
}  // namespace tetloft::test
