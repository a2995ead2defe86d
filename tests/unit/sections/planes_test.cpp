// arrange_planes(): sections in the order of their planes.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

SectionStack at_heights(std::initializer_list<double> heights) {
  SectionStack result;
  double x = 0;
  for (const double z : heights) {
    result.sections.push_back(section(z, {rectangle(x, 0, x + 1, 1)}));
    x += 2;
  }
  return result;
}

std::vector<double> heights_of(const ArrangedPlanes& arranged) {
  std::vector<double> heights;
  for (const Section& s : arranged.stack.sections) heights.push_back(s.z);
  return heights;
}

using Heights = std::vector<double>;

TEST(Planes, AreSortedAndThoseOfOneHeightMadeOne) {
  const auto sorted = arrange_planes(at_heights({3, 1, 3, -0.0, 0}));
  ASSERT_TRUE(sorted.ok());
  EXPECT_EQ(heights_of(*sorted), (Heights{0, 1, 3}));
  EXPECT_EQ(sorted->origin[SectionId(0)], (std::vector{SectionId(3), SectionId(4)}));
  EXPECT_EQ(sorted->origin[SectionId(1)], (std::vector{SectionId(1)}));
  EXPECT_EQ(sorted->origin[SectionId(2)], (std::vector{SectionId(0), SectionId(2)}));
  const auto& contours = sorted->stack.sections[SectionId(2)].contours;
  ASSERT_EQ(contours.size(), 2U);
  EXPECT_EQ(contours[ContourId(0)].vertices[0].x, 0);
  EXPECT_EQ(contours[ContourId(1)].vertices[0].x, 4);
  ASSERT_EQ(sorted->changes.size(), 2U);
  EXPECT_EQ(sorted->changes[1].message, "the sections 0 and 2 are one now");
  EXPECT_EQ(sorted->changes[1].where.section, 2U);
}

TEST(Planes, AreTurnedOverWhereTheyDescendOnly) {
  const auto turned = arrange_planes(at_heights({3, 1, 0}), {PlaneRule::flip, 0});
  ASSERT_TRUE(turned.ok());
  EXPECT_EQ(heights_of(*turned), (Heights{0, 1, 3}));
  EXPECT_TRUE(turned->changes.empty());
  for (const auto& heights :
       {at_heights({0, 1, 3}), at_heights({3, 1, 1}), at_heights({3, 0, 1})}) {
    const auto refused = arrange_planes(heights, {PlaneRule::flip, 0});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
    EXPECT_TRUE(refused.error().where.section == 1U || refused.error().where.section == 2U);
  }
}

TEST(Planes, AreMergedWithinTheToleranceFromTheLowestOn) {
  // A chain: each is 0.6 above the one before.
  const auto merged = arrange_planes(at_heights({0, 0.6, 1.2, 1.8, 2.4, 9}), {PlaneRule::merge, 1});
  ASSERT_TRUE(merged.ok());
  EXPECT_EQ(heights_of(*merged), (Heights{0, 1.2, 2.4, 9}));
  EXPECT_EQ(merged->origin[SectionId(1)], (std::vector{SectionId(2), SectionId(3)}));
  EXPECT_TRUE(validate(merged->stack).ok());
}

TEST(Planes, MergedLieWhereMostContoursDo) {
  SectionStack stack = at_heights({0, 0.1, 0.2});
  stack.sections[SectionId(1)].contours.push_back(rectangle(0, 5, 1, 6));
  const auto merged = arrange_planes(stack, {PlaneRule::merge, 0.5});
  ASSERT_TRUE(merged.ok());
  EXPECT_EQ(heights_of(*merged), (Heights{0.1}));
  EXPECT_EQ(merged->stack.contour_count(), 4U);
}

TEST(Planes, WithoutOrderAreRefused) {
  const auto refused = arrange_planes(at_heights({0, NAN, 1}));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.section, 1U);
  for (const PlaneOptions& bad :
       {PlaneOptions{PlaneRule::merge, 0}, PlaneOptions{PlaneRule::merge, NAN},
        PlaneOptions{static_cast<PlaneRule>(3), 1}}) {
    const auto unknown = arrange_planes(at_heights({0, 1}), bad);
    ASSERT_FALSE(unknown.ok());
    EXPECT_EQ(unknown.error().code, ErrorCode::usage);
  }
}

}  // namespace
}  // namespace tetloft::testing
