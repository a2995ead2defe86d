// Links by motion: rods that lean by more than their distance, and what lies still.
#include "correspondence/moved_links.hpp"

#include <gtest/gtest.h>

#include "correspondence/moved_ratio.hpp"
#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Motions = IdVector<RegionId, std::optional<Point2>>;

CorrespondenceOptions moved_alone() {
  CorrespondenceOptions options;
  options.criterion = Criterion::moved;
  options.chain = options.lone = false;
  return options;
}

struct Slab1 {
  SectionStack stack;
  IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  StackSections sections = sections_of(stack, nestings);
  [[nodiscard]] const SectionRegions& below() const { return sections[SectionId(0)]; }
  [[nodiscard]] const SectionRegions& above() const { return sections[SectionId(1)]; }
};

// Rods with sections of side 2, three apart, that lean by `lean` a section.
SectionStack rods(double lean, std::size_t sections = 4, std::size_t rods = 5) {
  SectionStack stack;
  for (std::size_t s = 0; s < sections; ++s) {
    const auto z = static_cast<double>(s);
    stack.sections.push_back({3 * z, {}});
    for (std::size_t r = 0; r < rods; ++r) {
      const double x = 3 * static_cast<double>(r) + lean * z;
      stack.sections[SectionId(s)].contours.push_back(box(x, 0, x + 2, 2));
    }
  }
  return stack;
}

TEST(MovedLinks, FollowRodsThatLeanOntoTheirNeighbours) {
  // Moved by 2, each covers a third of its neighbour's successor... and half of nothing else.
  CorrespondenceOptions overlap = moved_alone();
  overlap.criterion = Criterion::overlap;
  const SectionStack stack = rods(2);
  const Pairs each{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}};
  EXPECT_NE(links_of(stack, 1, overlap, Evidence::overlap), each);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(links_of(stack, k, moved_alone(), Evidence::motion), each) << k;
    EXPECT_EQ(links_of(stack, k, moved_alone(), Evidence::overlap), Pairs{}) << k;
  }
  EXPECT_EQ(components_by(stack, moved_alone()), 5U);
  EXPECT_EQ(components_by(upside_down(stack), moved_alone()), 5U);
}

TEST(MovedLinks, RegionsAtRestHaveNoMotion) {
  const Slab1 still{rods(0)};
  const SlabMotions motions =
      motions_where_unclear(SlabId(0), still.stack, still.nestings, still.below(), still.above(),
                            overlapping_pairs(still.below(), still.above()));
  for (const auto& by : motions.lower) EXPECT_FALSE(by);
  for (const auto& by : motions.upper) EXPECT_FALSE(by);
  EXPECT_TRUE(find_links(still.stack, {moved_alone(), {}})->motions.empty());
  EXPECT_FALSE(find_links(rods(2), {moved_alone(), {}})->motions.empty());
}

TEST(MovedLinks, AWeakPairWakesAllThatItTouches) {
  // Regions 0 and 1 below lie over one plate, and 1 over half of itself.
  const Slab1 slab{stack_of_boxes({{box(0, 0, 4, 4), box(6, 0, 10, 4), box(20, 0, 24, 4)},
                                   {box(-1, -1, 8, 5), box(20, 0, 24, 4)}})};
  const SlabMotions motions =
      motions_where_unclear(SlabId(0), slab.stack, slab.nestings, slab.below(), slab.above(),
                            overlapping_pairs(slab.below(), slab.above()));
  EXPECT_TRUE(motions.lower[RegionId(0)]);
  EXPECT_TRUE(motions.lower[RegionId(1)]);
  EXPECT_FALSE(motions.lower[RegionId(2)]);
  EXPECT_TRUE(motions.upper[RegionId(0)]);
  EXPECT_FALSE(motions.upper[RegionId(1)]);
}

TEST(MovedLinks, TheRatioIsTheMeanOfBothMotions) {
  const Slab1 slab{stack_of_boxes({{box(0, 0, 4, 4)}, {box(4, 0, 8, 4)}})};
  const auto ratio = [&](std::optional<Point2> low, std::optional<Point2> high) {
    const SlabMotions motions{Motions(1, low), Motions(1, high)};
    return MovedPairs(slab.below(), slab.above(), motions).ratio(RegionId(0), RegionId(0), 0);
  };
  EXPECT_EQ(ratio(std::nullopt, std::nullopt), 0);
  EXPECT_EQ(ratio(Point2{4, 0}, Point2{4, 0}), 1);
  EXPECT_EQ(ratio(Point2{4, 0}, std::nullopt), 0.5);
  EXPECT_EQ(ratio(std::nullopt, Point2{2, 0}), 0.25);
  EXPECT_EQ(ratio(Point2{1, 0}, Point2{3, 2}), (0.25 + 0.375) / 2);
  // Moved so far that rounding leaves no region.
  EXPECT_EQ(ratio(Point2{0x1p70, 0}, Point2{4, 0}), 0.5);
}

TEST(MovedLinks, TheFartherTheMoreMustOverlap) {
  // The gap is 1; d = 0.5 of it.
  const Slab1 slab{stack_of_boxes({{box(0, 0, 4, 4)}, {box(4.5, 0, 8.5, 4)}})};
  const auto links = [&](double by) {
    const SlabMotions motions{Motions(1, Point2{by, 0}), Motions(1, Point2{by, 0})};
    return moved_links(SlabId(0), slab.below(), slab.above(), {}, motions, 0.125);
  };
  // m = 0.625 is what it must exceed.
  ASSERT_EQ(links(3).size(), 1U);
  EXPECT_EQ(links(3)[0].fate, LinkFate::too_weak);
  EXPECT_EQ(links(3)[0].margin, 0);
  ASSERT_EQ(links(3.125).size(), 1U);
  EXPECT_TRUE(links(3.125)[0].made());
  EXPECT_EQ(links(3.125)[0].evidence, Evidence::motion);
  EXPECT_EQ(links(3.125)[0].distance, 0.5);
  EXPECT_TRUE(links(0).empty());
}

}  // namespace
}  // namespace tetloft::testing
