// Lone regions: what nothing links belongs to what is nearest, if near enough.
#include "correspondence/lone_links.hpp"

#include <gtest/gtest.h>

#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

CorrespondenceOptions lone_alone() {
  CorrespondenceOptions options;
  options.criterion = Criterion::overlap;
  options.chain = false;
  return options;
}

Pairs lone(const SectionStack& stack, std::size_t slab, LinkFate fate = LinkFate::made) {
  return links_of(stack, slab, lone_alone(), Evidence::lone, fate);
}

// A large square below, one of side `side` above at distance d; gap 8.
SectionStack beside(double d, double side) {
  SectionStack stack = stack_of_boxes({{box(0, 0, 64, 64)}, {box(64 + d, 0, 64 + d + side, side)}});
  stack.sections[SectionId(1)].z = 8;
  return stack;
}

TEST(LoneLinks, ReachHalfAGapAndSmallRegionsAWhole) {
  EXPECT_EQ(lone(beside(3.875, 8), 0), (Pairs{{0, 0}}));
  EXPECT_EQ(lone(beside(4, 8), 0), Pairs{});
  // The small one of two lone regions chooses; its area is below (gap / 2)² = 16.
  EXPECT_EQ(lone(beside(4, 3.875), 0), (Pairs{{0, 0}}));
  EXPECT_EQ(lone(beside(4, 4), 0), Pairs{});
  EXPECT_EQ(lone(beside(7.875, 3.875), 0), (Pairs{{0, 0}}));
  EXPECT_EQ(lone(beside(8, 3.875), 0), Pairs{});
}

TEST(LoneLinks, TellWhatWasNearestWhereNothingIsWithinReach) {
  EXPECT_EQ(lone(beside(4, 4), 0, LinkFate::too_weak), (Pairs{{0, 0}}));
  EXPECT_EQ(lone(beside(17, 4), 0, LinkFate::too_weak), Pairs{});
  const auto link = link_between(beside(6, 8), 0, 0, 0, lone_alone());
  ASSERT_TRUE(link);
  EXPECT_EQ(link->distance, 0.75);
  EXPECT_EQ(link->margin, -0.25);
  EXPECT_FALSE(link->lead);
}

TEST(LoneLinks, HolesDoNotCountAsArea) {
  // A frame of area 64 − 49 = 15.
  SectionStack stack = beside(4, 8);
  stack.sections[SectionId(1)].contours.push_back(box(68.5, 0.5, 75.5, 7.5));
  EXPECT_EQ(lone(stack, 0), (Pairs{{0, 0}}));
}

TEST(LoneLinks, AreOfFirstAndLastSectionsToo) {
  EXPECT_EQ(lone(upside_down(beside(3, 8)), 0), (Pairs{{0, 0}}));
  SectionStack stack = beside(3, 8);
  stack.sections.push_back(Section{16, {}});
  EXPECT_EQ(lone(stack, 0), (Pairs{{0, 0}}));
}

TEST(LoneLinks, ARegionWithALinkOnOneSideIsNotLone) {
  SectionStack stack = stack_of_boxes({{box(0, 0, 4, 4)}, {box(0, 0, 4, 4)}, {box(5, 0, 6, 1)}});
  for (const SectionId s : stack.sections.ids()) {
    stack.sections[s].z = 4 * static_cast<double>(s.index());
  }
  // The region above chooses; the middle one has its link.
  EXPECT_EQ(lone(stack, 1), (Pairs{{0, 0}}));
  stack.sections.push_back({12, IdVector<ContourId, Contour>({box(5, 0, 6, 1)})});
  EXPECT_EQ(lone(stack, 1), Pairs{});
}

TEST(LoneLinks, ChooseTheNearestAndOfEqualsTheLowerSlabThenTheLowerNumber) {
  // A square between four others: two below at equal distance, one above as far.
  const std::vector<Contour> middle{box(10, 0, 12, 2)};
  const std::vector<Contour> both{box(6, 0, 9, 2), box(13, 0, 16, 2)};
  EXPECT_EQ(lone(stack_of_boxes({both, middle}), 0).size(), 0U);  // d = 1
  SectionStack stack = stack_of_boxes({both, middle, both});
  for (const SectionId s : stack.sections.ids()) {
    stack.sections[s].z = 4 * static_cast<double>(s.index());
  }
  // All five are lone; those outside choose the middle one.
  EXPECT_EQ(lone(stack, 0), (Pairs{{0, 0}, {1, 0}}));
  EXPECT_EQ(lone(stack, 1), (Pairs{{0, 0}, {0, 1}}));
  // Linked ones do not choose.
  const std::vector<Contour> plate{box(6, 0, 9, 2), box(13, 0, 16, 2)};
  SectionStack between = stack_of_boxes({both, both, middle, both, both});
  for (const SectionId s : between.sections.ids()) {
    between.sections[s].z = 4 * static_cast<double>(s.index());
  }
  EXPECT_EQ(lone(between, 1), (Pairs{{0, 0}}));
  EXPECT_EQ(lone(between, 2), Pairs{});
  const auto link = link_between(between, 1, 0, 0, lone_alone());
  ASSERT_TRUE(link);
  EXPECT_EQ(link->lead, 0);
  // A little nearer above.
  between.sections[SectionId(3)].contours[ContourId(1)] = box(12.5, 0, 16, 2);
  EXPECT_EQ(lone(between, 1), Pairs{});
  EXPECT_EQ(lone(between, 2), (Pairs{{0, 1}}));
}

TEST(LoneLinks, AreLeftOutOnRequestAndByReverse) {
  CorrespondenceOptions options = lone_alone();
  EXPECT_EQ(components_by(beside(3, 8), options), 1U);
  options.lone = false;
  EXPECT_EQ(components_by(beside(3, 8), options), 2U);
  options.lone = true;
  options.criterion = Criterion::reverse;
  EXPECT_EQ(links_of(beside(3, 8), 0, options, Evidence::lone), Pairs{});
}

}  // namespace
}  // namespace tetloft::testing
