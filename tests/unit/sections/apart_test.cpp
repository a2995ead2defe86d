// Points that triangles inside a region have to keep out of their circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"
#include "support/exact/predicates.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

std::size_t circles_around(const ConformingSection& s, const Point2& p) {
  std::size_t count = 0;
  for (const TriangleId t : s.internal.ids()) {
    if (s.internal[t] == 0) continue;
    const PlaneTriangleVertices& v = s.triangulation.triangles[t];
    count += oracle::incircle(s.point(v[0]), s.point(v[1]), s.point(v[2]), p) > 0 ? 1U : 0U;
  }
  return count;
}

bool same_sections(const ConformingSection& a, const ConformingSection& b) {
  if (a.vertex_count() != b.vertex_count() || a.internal != b.internal) return false;
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    const Point2& p = a.point(PlaneVertexId(v));
    const Point2& q = b.point(PlaneVertexId(v));
    if (p.x != q.x || p.y != q.y) return false;
  }
  return a.triangulation.triangles == b.triangulation.triangles;
}

ConformingSection conformed(const Section& given, const std::vector<Point2>& apart,
                            const IdVector<ContourId, bool>& gabriel = {}) {
  ConformOptions options;
  options.apart = apart;
  options.gabriel = gabriel;
  auto result = conform(given, SectionId(0), options);
  EXPECT_TRUE(result.ok());
  return std::move(result).value();
}

// Split vertices lie on the axis-parallel edges that they split, all others are the input's.
void expect_splits_on_edges(const Section& given, const ConformingSection& s) {
  std::size_t input = 0;
  for (std::size_t i = 0; i < s.vertex_count(); ++i) {
    const PlaneVertexId v(i);
    const auto& contour = given.contours[s.contour[v]].vertices;
    const Point2& p = contour[s.edge_of[v]];
    const Point2& q = contour[(s.edge_of[v] + 1) % contour.size()];
    const Point2& at = s.point(v);
    if (s.input_vertex[v] != ConformingSection::kNotInput) {
      EXPECT_TRUE(at.x == p.x && at.y == p.y);
      ++input;
      continue;
    }
    EXPECT_EQ(oracle::orient2d(p, q, at), 0);
    EXPECT_TRUE(std::min(p.x, q.x) <= at.x && at.x <= std::max(p.x, q.x));
    EXPECT_TRUE(std::min(p.y, q.y) <= at.y && at.y <= std::max(p.y, q.y));
  }
  std::size_t vertices = 0;
  for (const Contour& c : given.contours) vertices += c.vertices.size();
  EXPECT_EQ(input, vertices);
}

// Under a bar 40 long circles reach far out.
const Section kBar = section(0, {rectangle(-20, 0, 20, 2)});

TEST(Apart, CirclesLeaveThePointsOut) {
  const Point2 beside{0, -1};
  const ConformingSection before = conformed(kBar, {});
  ASSERT_GT(circles_around(before, beside), 0U);
  const ConformingSection after = conformed(kBar, {beside});
  EXPECT_EQ(circles_around(after, beside), 0U);
  EXPECT_GT(after.vertex_count(), before.vertex_count());
  EXPECT_LT(after.vertex_count(), 40U);
  expect_splits_on_edges(kBar, after);
  for (std::size_t v = 0; v < after.vertex_count(); ++v) {
    EXPECT_FALSE(after.point(PlaneVertexId(v)).y == -1);  // it is no vertex
  }
}

TEST(Apart, WithoutNeedNothingChanges) {
  const Section square = section(0, {rectangle(0, 0, 8, 8)});
  EXPECT_TRUE(same_sections(conformed(square, {}), conformed(square, {{20, 20}, {-9, 4}})));
  // In the middle of a hole, where no circle reaches.
  const Section frame = section(0, {rectangle(-9, -9, 9, 9), rectangle(-8, -8, 8, 8)});
  const ConformingSection before = conformed(frame, {});
  ASSERT_EQ(circles_around(before, {0, 0}), 0U);
  EXPECT_TRUE(same_sections(before, conformed(frame, {{0, 0}})));
}

TEST(Apart, GoesTogetherWithGabrielEdges) {
  const Section two = section(0, {rectangle(-20, 0, 20, 2), rectangle(-20, 3, 20, 5)});
  const Point2 between{0.5, 2.5};
  IdVector<ContourId, bool> gabriel(2, false);
  gabriel[ContourId(1U)] = true;
  const ConformingSection both = conformed(two, {between}, gabriel);
  EXPECT_EQ(circles_around(both, between), 0U);
  expect_splits_on_edges(two, both);
  EXPECT_EQ(both.gabriel, gabriel);
  for (std::size_t i = 0; i < both.vertex_count(); ++i) {
    const PlaneVertexId v(i);
    if (both.contour[v] != ContourId(1U)) continue;
    const Point2& p = both.point(v);
    const Point2& q = both.point(both.next[v]);
    for (std::size_t w = 0; w < both.vertex_count(); ++w) {
      const Point2& r = both.point(PlaneVertexId(w));
      // Small numbers: exact in double.
      EXPECT_GE((p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y), 0);
    }
  }
}

TEST(Apart, HoldsOnGeneratedSections) {
  Prng prng(91);
  std::size_t points = 0;
  std::size_t inside_before = 0;
  for (const StackKind kind : kinds_with_voids()) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const Section given = generate(kind, seed).stack.sections[SectionId(0)];
      const ConformingSection before = conformed(given, {});
      std::vector<Point2> apart;
      for (int k = 0; k < 40 && apart.size() < 3; ++k) {
        // On quarters: none on a contour but where the filter below says so.
        const Point2 p{static_cast<double>(prng.below(81)) / 4 - 10.0625,
                       static_cast<double>(prng.below(81)) / 4 - 10.0625};
        bool inside = false;
        for (const Contour& c : given.contours) inside = inside != is_inside(c, p);
        double nearest = 1;
        for (std::size_t v = 0; v < before.vertex_count(); ++v) {
          const Point2& q = before.point(PlaneVertexId(v));
          nearest = std::min(nearest, std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)));
        }
        if (!inside && nearest > 0.05) apart.push_back(p);
      }
      const ConformingSection after = conformed(given, apart);
      for (const Point2& p : apart) {
        inside_before += circles_around(before, p) > 0 ? 1U : 0U;
        EXPECT_EQ(circles_around(after, p), 0U);
      }
      points += apart.size();
    }
  }
  EXPECT_GT(points, 80U);
  EXPECT_GT(inside_before, 10U);
}

}  // namespace
}  // namespace tetloft::testing
