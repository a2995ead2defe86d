// nest(), outline() and areas against definitions.
#include <gtest/gtest.h>

#include <cmath>

#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

// Nested as their definition says: contours are disjoint, so one vertex tells.
void expect_nested_by_definition(const Section& section) {
  const Nesting nesting = nest(section);
  const std::size_t n = section.contours.size();
  ASSERT_EQ(nesting.parent.size(), n);
  std::vector<std::vector<bool>> in(n, std::vector<bool>(n, false));
  std::vector<std::uint32_t> depth(n, 0);
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t d = 0; d < n; ++d) {
      const Point2& p = section.contours[ContourId(c)].vertices[0];
      in[c][d] = c != d && is_inside(section.contours[ContourId(d)], p);
      depth[c] += in[c][d] ? 1U : 0U;
    }
  }
  for (std::size_t c = 0; c < n; ++c) {
    ASSERT_EQ(nesting.depth[ContourId(c)], depth[c]);
    ContourId parent;
    for (std::size_t d = 0; d < n; ++d) {
      if (in[c][d] && depth[d] + 1 == depth[c]) parent = ContourId(d);
    }
    ASSERT_EQ(nesting.parent[ContourId(c)], parent);
    const RegionId region = nesting.region[ContourId(c)];
    const ContourId outer = depth[c] % 2 == 0 ? ContourId(c) : parent;
    ASSERT_EQ(nesting.outer[region], outer);
  }
}

Point2 lowest(const Contour& contour) {
  Point2 low = contour.vertices[0];
  for (const Point2& p : contour.vertices) low = canonical_less(p, low) ? p : low;
  return low;
}

TEST(Nest, AgreesWithPointInPolygon) {
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      for (const Section& section : generate(kind, seed).stack.sections) {
        expect_nested_by_definition(section);
        if (HasFatalFailure()) FAIL() << name_of(kind) << " seed " << seed;
      }
    }
  }
}

TEST(Nest, SeesNotchesAndTouchingRanges) {
  // A contour in the notch of another, above and below it, but not inside.
  const Contour notched =
      contour({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 7}, {7, 7}, {7, 3}, {0, 3}});
  const Section section =
      testing::section(0, {rectangle(1, 4, 3, 6), notched, rectangle(8, 1, 9, 2),
                           rectangle(11, -50, 12, 50), rectangle(8.25, 1.25, 8.75, 1.75)});
  expect_nested_by_definition(section);
  const Nesting nesting = nest(section);
  EXPECT_FALSE(nesting.parent[ContourId(0)].valid());
  EXPECT_EQ(nesting.parent[ContourId(2)], ContourId(1));
  EXPECT_EQ(nesting.depth[ContourId(4)], 2U);
}

TEST(Nest, NumbersRegionsByTheirLowestVertices) {
  for (const StackKind kind : {StackKind::nesting, StackKind::lattice_staircase}) {
    for (const Section& section : generate(kind, 3).stack.sections) {
      const Nesting nesting = nest(section);
      for (std::size_t r = 1; r < nesting.outer.size(); ++r) {
        EXPECT_TRUE(canonical_less(lowest(section.contours[nesting.outer[RegionId(r - 1)]]),
                                   lowest(section.contours[nesting.outer[RegionId(r)]])));
      }
    }
  }
}

TEST(Nest, TakesASectionWithoutContours) { EXPECT_TRUE(nest(Section{}).parent.empty()); }

TEST(Outline, HoldsTheOuterContourFirstThenTheHoles) {
  const Section section =
      testing::section(0, {rectangle(2, 2, 3, 3), rectangle(0, 0, 10, 10), rectangle(5, 5, 9, 9),
                           rectangle(6, 6, 8, 8), rectangle(20, 0, 30, 10)});
  const Nesting nesting = nest(section);
  ASSERT_EQ(nesting.outer.size(), 3U);
  const RegionOutline first = outline(section, nesting, RegionId(0));
  ASSERT_EQ(first.contours.size(), 3U);
  EXPECT_EQ(first.contours[0], &section.contours[ContourId(1)]);
  EXPECT_EQ(first.contours[1], &section.contours[ContourId(0)]);
  EXPECT_EQ(first.contours[2], &section.contours[ContourId(2)]);
  EXPECT_EQ(area(first), 100 - 1 - 16);
  EXPECT_EQ(area(outline(section, nesting, RegionId(1))), 4);
}

TEST(TwiceArea, IsPositiveIffCounterClockwise) {
  EXPECT_DOUBLE_EQ(twice_area(rectangle(0, 0, 3, 4)), 24);
  EXPECT_DOUBLE_EQ(twice_area(reversed(rectangle(0, 0, 3, 4))), -24);
  EXPECT_EQ(area_sign(rectangle(0, 0, 3, 4)), Sign::positive);
  EXPECT_EQ(area_sign(reversed(rectangle(0, 0, 3, 4))), Sign::negative);
}

TEST(TwiceArea, HasTheExactSignWhereRoundingHidesIt) {
  // Off a line by one unit in the last place, far from the origin.
  const double up = std::nextafter(3e8 + 0.1, 1e9);
  const Contour thin = contour({{1e8 + 0.1, 1e8 + 0.1}, {2e8 + 0.1, 2e8 + 0.1}, {3e8 + 0.1, up}});
  const oracle::Rational exact = exact_area({thin});
  EXPECT_NE(area_sign(thin), Sign::zero);
  EXPECT_EQ(area_sign(thin), -area_sign(reversed(thin)));
  EXPECT_NEAR(std::abs(twice_area(thin)) / (2 * exact.approximate()), 1, 1e-12);
  EXPECT_EQ(area_sign(contour({{0, 0}, {1, 1}, {1, 0}, {0, 1}})), Sign::zero);
  EXPECT_EQ(area_sign(contour({{0.1, 0.1}, {0.2, 0.2}, {0.4, 0.4}})), Sign::zero);
}

TEST(TwiceArea, CoversAllScales) {
  for (const double factor : {0x1p-1070, 0x1p-600, 0x1p500, 0x1p990}) {
    const Contour scaled = moved(rectangle(0, 0, 3, 4), factor, {0, 0});
    EXPECT_EQ(area_sign(scaled), Sign::positive) << factor;
    EXPECT_EQ(area_sign(reversed(scaled)), Sign::negative) << factor;
  }
  EXPECT_DOUBLE_EQ(twice_area(moved(rectangle(0, 0, 3, 4), 0x1p500, {0, 0})), 24 * 0x1p1000);
  // Coordinates of such different magnitude that no common scale is exact.
  EXPECT_EQ(area_sign(contour({{0x1p999, 0}, {0, 0x1p-1074}, {0, 0}})), Sign::positive);
}

}  // namespace
}  // namespace tetloft::testing
