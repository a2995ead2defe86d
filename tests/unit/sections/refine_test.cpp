// Long contour edges in equal parts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <tetloft/sections.hpp>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

SectionStack one(std::vector<Contour> contours) {
  SectionStack stack;
  stack.sections.resize(1);
  for (Contour& contour : contours) {
    stack.sections[SectionId(0)].contours.push_back(std::move(contour));
  }
  return stack;
}

const std::vector<Point2>& vertices_of(const Refined& refined) {
  return refined.stack.sections[SectionId(0)].contours[ContourId(0)].vertices;
}

TEST(Refine, DividesLongEdgesIntoEqualParts) {
  const auto refined = refine(one({Contour{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}}}), 1);
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->inserted, 6U);
  EXPECT_EQ(vertices_of(*refined),
            (std::vector<Point2>{
                {0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {4, 1}, {3, 1}, {2, 1}, {1, 1}, {0, 1}}));
}

TEST(Refine, LeavesShortEdgesAlone) {
  const SectionStack stack = one({Contour{{{0, 0}, {4, 0}, {4, 1}}}});
  const auto refined = refine(stack, 4.2);
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->inserted, 0U);
  EXPECT_EQ(vertices_of(*refined), stack.sections[SectionId(0)].contours[ContourId(0)].vertices);
}

TEST(Refine, DependsNotOnDirection) {
  Prng prng(5);
  for (int round = 0; round < 200; ++round) {
    const auto point = [&] { return Point2{prng.between(-9, 9), prng.between(-9, 9)}; };
    std::vector<Point2> v{point(), point(), point()};
    const double length = prng.between(0.1, 3);
    const auto there = refine(one({Contour{v}}), length);
    std::reverse(v.begin(), v.end());
    const auto back = refine(one({Contour{v}}), length);
    ASSERT_EQ(there.ok(), back.ok());
    if (!there) continue;
    const auto sorted = [](std::vector<Point2> points) {
      std::sort(points.begin(), points.end(),
                [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
      return points;
    };
    ASSERT_EQ(sorted(vertices_of(*there)), sorted(vertices_of(*back)));
    const auto& points = vertices_of(*there);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Point2 p = points[k], q = points[(k + 1) % points.size()];
      ASSERT_LE(std::hypot(q.x - p.x, q.y - p.y), length * (1 + 1e-12));
    }
  }
}

TEST(Refine, RefusesLengthsThatMakeNoSense) {
  const SectionStack stack = one({Contour{{{0, 0}, {4, 0}, {4, 1}}}});
  for (const double length : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-12}) {
    const auto refused = refine(stack, length);
    ASSERT_FALSE(refused) << length;
    EXPECT_EQ(refused.error().code, ErrorCode::usage);
  }
  const auto invalid = refine(one({Contour{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}), 1);
  ASSERT_FALSE(invalid);
  EXPECT_EQ(invalid.error().code, ErrorCode::invalid_input);
}

TEST(Refine, DividesNothingBelowTheSpacingOfDoubles) {
  const double next = std::nextafter(1e6, HUGE_VAL);
  const auto refined =
      refine(one({Contour{{{1e6, 0}, {next, 0}, {next, 0x1p-30}, {1e6, 0x1p-30}}}}), 0x1p-37);
  ASSERT_TRUE(refined) << to_string(refined.error());
  EXPECT_EQ(refined->inserted, 2U * 127U);
}

}  // namespace
}  // namespace tetloft
