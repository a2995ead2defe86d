// Voronoi skeletons: duals of internal and external edges.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

ConformingSection conformed(const Section& section) {
  Result<ConformingSection> s = conform(section, SectionId(0));
  EXPECT_TRUE(s.ok());
  return std::move(s).value();
}

TEST(VoronoiSkeleton, OfTwoSquaresSeparatesThem) {
  const ConformingSection s = conformed(section(0, {rectangle(0, 0, 2, 2), rectangle(6, 0, 8, 2)}));
  // Between the squares: two triangles, dual vertices on the axis x = 4.
  bool between = false;
  for (const SkeletonEdge& e : voronoi_skeleton(s, EdgeKind::external)) {
    if (e.contour_a == e.contour_b) continue;
    between = true;
    EXPECT_EQ(e.from.x, 4);
    EXPECT_EQ(e.ray ? e.to.x : e.to.x - 4, 0);
  }
  EXPECT_TRUE(between);
}

TEST(VoronoiSkeleton, RaysPointAwayFromTheHull) {
  // The lower hull edge between two triangles: its ray goes straight down.
  const ConformingSection s = conformed(
      section(0, {contour({{0, 0}, {1, 2}, {-1, 2}}), contour({{8, 0}, {9, 2}, {7, 2}})}));
  int down = 0;
  for (const SkeletonEdge& e : voronoi_skeleton(s, EdgeKind::external)) {
    if (!e.ray) continue;
    EXPECT_FALSE(e.right.valid());
    EXPECT_TRUE(e.left.valid());
    // The triangle's third corner lies on the other side.
    const Point2& a = s.point(s.edges[e.dual].a);
    for (const PlaneVertexId v : s.triangulation.triangles[e.left]) {
      if (v == s.edges[e.dual].a || v == s.edges[e.dual].b) continue;
      EXPECT_LT((s.point(v).x - a.x) * e.to.x + (s.point(v).y - a.y) * e.to.y, 0);
    }
    down += e.to.x == 0 && e.to.y < 0 ? 1 : 0;
  }
  EXPECT_EQ(down, 1);
}

TEST(VoronoiSkeleton, OfATriangleHasNoInternalEdge) {
  const ConformingSection s = conformed(section(0, {contour({{0, 0}, {4, 0}, {0, 4}})}));
  EXPECT_TRUE(voronoi_skeleton(s, EdgeKind::internal).empty());
  EXPECT_TRUE(voronoi_skeleton(s, EdgeKind::external).empty());
}

TEST(VoronoiSkeleton, HasOneDualForEveryEdgeOfItsKind) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 2).stack;
    const Result<ConformingSection> s = conform(stack.sections[SectionId(0)], SectionId(0));
    if (!s) continue;
    for (const EdgeKind edges : {EdgeKind::internal, EdgeKind::external}) {
      const std::vector<SkeletonEdge> all = voronoi_skeleton(*s, edges);
      std::size_t k = 0;
      std::vector<std::size_t> of_contour(stack.sections[SectionId(0)].contours.size(), 0);
      for (std::size_t e = 0; e < s->edges.size(); ++e) {
        const ConformingSection::Edge& edge = s->edges[EdgeId(e)];
        if (edge.kind != edges) continue;
        ASSERT_LT(k, all.size());
        ASSERT_EQ(all[k].dual, EdgeId(e));
        ASSERT_EQ(all[k].kind, edges);
        ASSERT_EQ(all[k].contour_a, s->contour[edge.a]);
        ASSERT_EQ(all[k].contour_b, s->contour[edge.b]);
        ASSERT_EQ(all[k].ray, !edge.left.valid() || !edge.right.valid());
        ++of_contour[s->contour[edge.a].index()];
        if (s->contour[edge.a] != s->contour[edge.b]) ++of_contour[s->contour[edge.b].index()];
        ++k;
      }
      ASSERT_EQ(k, all.size());
      for (std::size_t c = 0; c < of_contour.size(); ++c) {
        const std::vector<SkeletonEdge> part = voronoi_skeleton(*s, edges, ContourId(c));
        ASSERT_EQ(part.size(), of_contour[c]);
        for (const SkeletonEdge& e : part) {
          ASSERT_TRUE(e.contour_a == ContourId(c) || e.contour_b == ContourId(c));
        }
      }
    }
  }
}

TEST(VoronoiSkeleton, EdgesAreAtRightAnglesToTheirDuals) {
  Prng prng(3);
  const ConformingSection s = conformed(section(0, {random_star(prng, 0, 0, 50, 30)}));
  for (const EdgeKind kind : {EdgeKind::internal, EdgeKind::external}) {
    for (const SkeletonEdge& e : voronoi_skeleton(s, kind)) {
      const ConformingSection::Edge& dual = s.edges[e.dual];
      const Point2 d{s.point(dual.b).x - s.point(dual.a).x, s.point(dual.b).y - s.point(dual.a).y};
      const Point2 v = e.ray ? e.to : Point2{e.to.x - e.from.x, e.to.y - e.from.y};
      const double size = std::abs(d.x * v.x) + std::abs(d.y * v.y) + std::abs(e.from.x) + 1;
      EXPECT_NEAR((d.x * v.x + d.y * v.y) / size, 0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
