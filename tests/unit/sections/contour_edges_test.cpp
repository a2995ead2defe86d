// Where points lie, against winding counted in rationals.
#include "sections/contour_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/prng.hpp"
#include "support/exact/rational.hpp"
#include "support/stacks/generate.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using oracle::Rational;
using sections::ContourEdges;
using Where = ContourEdges::Where;

// By a ray in direction −y, every edge looked at: where it meets x = p.x, in rationals.
Where by_all_edges(const ConformingSection& section, const Point2& p) {
  const Rational x = Rational::exactly(p.x);
  const Rational y = Rational::exactly(p.y);
  bool odd = false;
  for (const PlaneVertexId v : section.next.ids()) {
    if (!section.next[v].valid()) continue;
    const std::array<Point2, 2> end{section.point(v), section.point(section.next[v])};
    const auto [left, right] = std::minmax(end[0].x, end[1].x);
    if (p.x < left || p.x > right) continue;
    const Rational ax = Rational::exactly(end[0].x), ay = Rational::exactly(end[0].y);
    const Rational bx = Rational::exactly(end[1].x), by = Rational::exactly(end[1].y);
    if (left == right) {
      if (p.y >= std::min(end[0].y, end[1].y) && p.y <= std::max(end[0].y, end[1].y)) {
        return Where::boundary;
      }
      continue;
    }
    const Rational at = ay + (by - ay) * (x - ax) / (bx - ax);
    if ((at <=> y) == 0) return Where::boundary;
    // Half-open: a vertex belongs to the edge on its right.
    if (p.x < right && at < y) odd = !odd;
  }
  return odd ? Where::inside : Where::outside;
}

TEST(ContourEdges, LocateAsRationalsDo) {
  Prng prng(960);
  std::array<std::size_t, 3> seen{};
  for (const StackKind kind : all_kinds()) {
    SCOPED_TRACE(name_of(kind));
    const SectionStack stack = generate(kind, 961).stack;
    const Result<ConformingSection> section = conform(stack.sections[SectionId(0)], SectionId(0));
    if (!section || section->vertex_count() == 0 || section->vertex_count() > 500) continue;
    const ContourEdges contours(*section);
    const auto vertex = [&] {
      return section->point(PlaneVertexId(prng.below(section->vertex_count())));
    };
    for (int k = 0; k < 60; ++k) {
      // Vertices, points level with vertices, means of vertices: on edges, often, or near them.
      const Point2 a = vertex(), b = vertex();
      for (const Point2& p : {a, Point2{a.x, b.y}, Point2{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}}) {
        const Where where = contours.locate(p);
        ASSERT_EQ(where, by_all_edges(*section, p)) << p.x << ' ' << p.y;
        ++seen.at(static_cast<std::size_t>(where));
      }
    }
  }
  for (const std::size_t count : seen) EXPECT_GT(count, 100U);
}

TEST(ContourEdges, OfAnEmptySectionHaveEverythingOutside) {
  const ContourEdges contours(conform(Section{}, SectionId(0)).value());
  EXPECT_EQ(contours.locate({0, 0}), Where::outside);
}

}  // namespace
}  // namespace tetloft::testing
