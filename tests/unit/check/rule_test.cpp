// Chains, lone regions, moved overlap, decisions and dropped links, in the rule of
// correspondence.hpp as check recomputes it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "unit/check/rule_stacks.hpp"

namespace tetloft {

using namespace internal;
namespace {

using testing::box;
using testing::Classes;
using testing::classes;
using testing::labelled;
using testing::plain;
using testing::stack_of;

CorrespondenceOptions with_chains() {
  CorrespondenceOptions options = plain();
  options.chain = true;
  return options;
}
CorrespondenceOptions with_lone() {
  CorrespondenceOptions options = plain();
  options.lone = true;
  return options;
}
CorrespondenceOptions moved() {
  CorrespondenceOptions options = plain();
  options.criterion = Criterion::moved;
  return options;
}

Contour square(double x, double side = 10) { return box(x, 0, x + side, side); }

// Chains.

TEST(Chains, MoveOnWhereNothingOverlaps) {
  const SectionStack stack = stack_of({{square(0, 4)}, {square(2, 4)}, {square(7, 4)}});
  EXPECT_EQ(classes(stack), (Classes{0, 0, 1}));
  EXPECT_EQ(classes(stack, with_chains()), (Classes{0, 0, 0}));
  const SectionStack down = stack_of({{square(7, 4)}, {square(2, 4)}, {square(0, 4)}});
  EXPECT_EQ(classes(down), (Classes{0, 1, 1}));
  EXPECT_EQ(classes(down, with_chains()), (Classes{0, 0, 0}));
}

TEST(Chains, OverlapByMoreThanATenth) {
  // From 4 to 14 where it is moved on.
  EXPECT_EQ(classes(stack_of({{square(-4)}, {square(0)}, {square(13)}}, 4), with_chains()),
            (Classes{0, 0, 1}));
  EXPECT_EQ(classes(stack_of({{square(-4)}, {square(0)}, {square(12.875)}}, 4), with_chains()),
            (Classes{0, 0, 0}));
}

TEST(Chains, ReachAsFarAsTheGap) {
  const double gap = 1 / kChainReach;
  EXPECT_EQ(classes(stack_of({{square(-9)}, {square(0)}, {square(11)}}, gap), with_chains()),
            (Classes{0, 0, 0}));
  EXPECT_EQ(classes(stack_of({{square(-9)}, {square(0)}, {square(11.0625)}}, gap), with_chains()),
            (Classes{0, 0, 1}));
}

TEST(Chains, MoveInProportionToTheGaps) {
  SectionStack stack = stack_of({{square(-4)}, {square(0)}, {square(16)}}, 8);
  EXPECT_EQ(classes(stack, with_chains()), (Classes{0, 0, 1}));
  stack.sections[SectionId(2)].z = 8 + 24;  // three gaps: to 12
  EXPECT_EQ(classes(stack, with_chains()), (Classes{0, 0, 0}));
}

TEST(Chains, FollowOneCandidateOnly) {
  EXPECT_EQ(
      classes(stack_of({{square(-9), square(9.5)}, {square(0)}, {square(10.5)}}), with_chains()),
      (Classes{0, 0, 0, 1}));
}

TEST(Chains, StartAtWhatIsNearest) {
  const auto chained = [](const std::vector<std::vector<Contour>>& layers) {
    return classes(stack_of(layers, 1 / kChainReach), with_chains());
  };
  EXPECT_EQ(chained({{square(-11)}, {square(0)}, {square(10.5)}}), (Classes{0, 0, 0}));
  EXPECT_EQ(chained({{square(-11.0625)}, {square(0)}, {square(10.5)}}), (Classes{0, 1, 2}));
  // The nearer of two; of two equally near ones that of lower number, on the left.
  EXPECT_EQ(chained({{square(-11), square(10.75)}, {square(0)}, {square(-10.5)}}),
            (Classes{0, 1, 1, 1}));
  EXPECT_EQ(chained({{square(11), square(-11)}, {square(0)}, {square(10.5)}}),
            (Classes{0, 1, 1, 1}));
  EXPECT_EQ(chained({{square(11), square(-11)}, {square(0)}, {square(-10.5)}}),
            (Classes{0, 1, 0, 2}));
}

TEST(Chains, LeadToSingleRegionsOnly) {
  const std::vector<Contour> middle{square(0, 4), square(7, 4)};
  EXPECT_EQ(classes(stack_of({{square(-2, 4)}, middle, {square(5, 4)}}), with_chains()),
            (Classes{0, 0, 1, 1}));
}

TEST(Chains, MoveRegionsWithTheirHoles) {
  const std::vector<Contour> low{box(0, 0, 8, 8), box(1, 1, 7, 7)};
  const std::vector<Contour> high{box(5, 0, 13, 8), box(6, 1, 12, 7)};
  EXPECT_EQ(classes(stack_of({low, high, {box(13.5, 3, 15, 5)}}), with_chains()),
            (Classes{0, 0, 0, 0, 1}));
  EXPECT_EQ(classes(stack_of({low, high, {box(13.5, 3, 17.5, 5)}}), with_chains()),
            (Classes{0, 0, 0, 0, 0}));
}

TEST(Chains, CountWithTheRatioMovedOnWhereLabelsCompete) {
  // 0.25 below, 0.5 − 0.1 above.
  const SectionStack stack = stack_of({{square(-1, 4)}, {square(2, 4)}, {square(7, 4)}}, 10);
  EXPECT_EQ(classes(stack, labelled({{0, 0, 1}, {2, 0, 2}}, with_chains())), (Classes{0, 1, 1}));
}

// Lone regions.

TEST(LoneRegions, AreJoinedWithWhatIsNearerThanHalfAGap) {
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(10.4375)}})), (Classes{0, 1}));
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(10.4375)}}), with_lone()), (Classes{0, 0}));
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(10.5)}}), with_lone()), (Classes{0, 1}));
}

TEST(LoneRegions, SmallOnesReachAWholeGap) {
  const std::vector<Contour> small{square(0, 0.25)};
  EXPECT_EQ(classes(stack_of({small, {square(1)}, {square(1)}}), with_lone()), (Classes{0, 0, 0}));
  EXPECT_EQ(classes(stack_of({small, {square(1.25)}, {square(1.25)}}), with_lone()),
            (Classes{0, 1, 1}));
  // What is small is the lone one, not the other.
  EXPECT_EQ(classes(stack_of({{square(1)}, small, small}), with_lone()), (Classes{0, 1, 1}));
  // Of area (gap / 2)² it is not small; without its hole it is.
  EXPECT_EQ(classes(stack_of({{square(0.25, 0.5)}, {square(1.5)}, {square(1.5)}}), with_lone()),
            (Classes{0, 1, 1}));
  EXPECT_EQ(classes(stack_of({{square(0, 0.75), box(0.0625, 0.0625, 0.6875, 0.6875)},
                              {square(1.5)},
                              {square(1.5)}}),
                    with_lone()),
            (Classes{0, 0, 0, 0}));
}

TEST(LoneRegions, AreThoseWithoutCandidateOnEitherSide) {
  // The middle one is linked below.
  EXPECT_EQ(
      classes(stack_of({{square(0)}, {square(0)}, {square(10.25)}, {square(10.25)}}), with_lone()),
      (Classes{0, 0, 1, 1}));
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(0)}, {square(10.25)}}), with_lone()),
            (Classes{0, 0, 0}));
}

TEST(LoneRegions, PreferTheLargestScore) {
  const std::vector<Contour> left{square(-10.25)};
  const std::vector<Contour> right{square(10.125)};
  // Nearer above, then below.
  EXPECT_EQ(classes(stack_of({left, left, {square(0)}, right, right}), with_lone()),
            (Classes{0, 0, 1, 1, 1}));
  EXPECT_EQ(classes(stack_of({right, right, {square(0)}, left, left}), with_lone()),
            (Classes{0, 0, 0, 1, 1}));
  // An overlap too weak for a candidate counts more than being near.
  CorrespondenceOptions options = with_lone();
  options.tau = 0.5;
  EXPECT_EQ(classes(stack_of({right, right, {square(0)}, {square(-9)}, {square(-9)}}), options),
            (Classes{0, 0, 1, 1, 1}));
}

TEST(LoneRegions, PreferTheLowerSlabThenTheLowerRegionOfEqualOnes) {
  const std::vector<Contour> left{square(-10.25)};
  const std::vector<Contour> right{square(10.25)};
  EXPECT_EQ(classes(stack_of({right, right, {square(0)}, left, left}), with_lone()),
            (Classes{0, 0, 0, 1, 1}));
  const std::vector<Contour> both{square(10.25), square(-10.25)};
  EXPECT_EQ(classes(stack_of({{square(0)}, both, both}), with_lone()), (Classes{0, 1, 0, 1, 0}));
}

TEST(LoneRegions, ChooseAllAtOnce) {
  // Each prefers the next one to the one before.
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(10.4375)}, {square(20.8125)}}), with_lone()),
            (Classes{0, 0, 0}));
}

// Moved overlap.

RegionMotion motion(std::uint32_t slab, bool upper, std::uint32_t contour, double x) {
  return {SlabId(slab), upper, ContourId(contour), {x, 0}};
}

// Two squares of side 4 half a gap apart.
SectionStack apart() { return stack_of({{square(0, 4)}, {square(6, 4)}}, 4); }

std::vector<std::string> wrong_motions(const SectionStack& stack,
                                       const std::vector<RegionMotion>& motions) {
  const auto expected = checking::expected_partition(stack, stack, moved(), {{}, motions});
  EXPECT_TRUE(expected.ok());
  return expected.ok() ? expected->wrong_motions : std::vector<std::string>{"refused"};
}

TEST(MovedOverlap, IsTheMeanOfBothWays) {
  const std::vector<RegionMotion> both{motion(0, false, 0, 6), motion(0, true, 0, 6)};
  const std::vector<RegionMotion> still{motion(0, false, 0, 0)};
  EXPECT_EQ(classes(apart(), moved(), {{}, still}), (Classes{0, 1}));
  EXPECT_EQ(classes(apart(), moved(), {{}, both}), (Classes{0, 0}));
  for (const RegionMotion& one : both) {
    const std::vector<RegionMotion> alone{one};
    EXPECT_EQ(classes(apart(), moved(), {{}, alone}), (Classes{0, 1}));
  }
}

TEST(MovedOverlap, ExceedsTheThresholdAndTheDistance) {
  // (1 + 0.5) / 2 against tau + 0.5.
  const std::vector<RegionMotion> motions{motion(0, false, 0, 6), motion(0, true, 0, 8)};
  CorrespondenceOptions options = moved();
  options.tau = 0.25;
  EXPECT_EQ(classes(apart(), options, {{}, motions}), (Classes{0, 1}));
  options.tau = 0.2499;
  EXPECT_EQ(classes(apart(), options, {{}, motions}), (Classes{0, 0}));
}

TEST(MovedOverlap, IsNoneOfWhatIsNoRegionAnyMoreWhereItIsMoved) {
  const std::vector<RegionMotion> both{motion(0, false, 0, 6), motion(0, true, 0, 6)};
  SectionStack stack = stack_of({{square(-1, 4)}, {square(5, 4)}}, 4);
  EXPECT_EQ(classes(stack, moved(), {{}, both}), (Classes{0, 0}));
  // A hole so small that rounding closes it elsewhere.
  stack.sections[SectionId(0)].contours.push_back(box(0x1p-60, 0x1p-60, 0x1p-59, 0x1p-59));
  EXPECT_EQ(classes(stack, moved(), {{}, both}), (Classes{0, 0, 1}));
}

TEST(MovedOverlap, CountsMotionsAsItTellsThem) {
  EXPECT_EQ(wrong_motions(apart(), {motion(0, false, 0, 6), motion(0, true, 0, 6)}),
            std::vector<std::string>());
  EXPECT_EQ(wrong_motions(apart(), {motion(0, false, 0, 6), motion(0, false, 0, 6)}).size(), 1U);
  EXPECT_EQ(wrong_motions(apart(), {motion(1, false, 0, 6)}).size(), 1U);
  EXPECT_EQ(wrong_motions(apart(), {motion(0, false, 1, 6)}).size(), 1U);
  EXPECT_EQ(wrong_motions(apart(), {{SlabId(), false, ContourId(0), {1, 0}}}).size(), 1U);
  EXPECT_EQ(wrong_motions(apart(), {{SlabId(0), false, ContourId(), {1, 0}}}).size(), 1U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(wrong_motions(apart(), {motion(0, false, 0, nan)}).size(), 1U);
  SectionStack frame = apart();
  frame.sections[SectionId(0)].contours.push_back(box(1, 1, 3, 3));
  EXPECT_EQ(wrong_motions(frame, {motion(0, false, 1, 6)}).size(), 1U);
  EXPECT_EQ(wrong_motions(frame, {motion(0, false, 0, 6)}).size(), 0U);
}

TEST(MovedOverlap, LeavesRegionsAtRest) {
  const std::vector<RegionMotion> lower{motion(0, false, 0, 1)};
  const std::vector<RegionMotion> upper{motion(0, true, 0, 1)};
  // Seven tenths, exactly, and less.
  const SectionStack rests = stack_of({{square(0)}, {square(3)}});
  EXPECT_EQ(wrong_motions(rests, lower).size(), 1U);
  EXPECT_EQ(wrong_motions(rests, upper).size(), 1U);
  const SectionStack moves = stack_of({{square(0)}, {square(3.0625)}});
  EXPECT_EQ(wrong_motions(moves, lower).size(), 0U);
  EXPECT_EQ(wrong_motions(moves, upper).size(), 0U);
  // A partner that reaches elsewhere: none of the three rests, but a fourth one does.
  const SectionStack shared =
      stack_of({{square(0), box(10.5, 0, 20.5, 10), square(30)}, {box(0, 0, 12, 10), square(30)}});
  for (const std::uint32_t contour : {0U, 1U}) {
    EXPECT_EQ(wrong_motions(shared, {motion(0, false, contour, 1)}).size(), 0U) << contour;
  }
  EXPECT_EQ(wrong_motions(shared, {motion(0, true, 0, 1)}).size(), 0U);
  EXPECT_EQ(wrong_motions(shared, {motion(0, false, 2, 1)}).size(), 1U);
  EXPECT_EQ(wrong_motions(shared, {motion(0, true, 1, 1)}).size(), 1U);
}

TEST(MovedOverlap, LeavesRegionsWithNothingNear) {
  const std::vector<RegionMotion> lower{motion(0, false, 0, 1)};
  EXPECT_EQ(wrong_motions(stack_of({{square(0)}, {square(11)}}), lower).size(), 0U);
  EXPECT_EQ(wrong_motions(stack_of({{square(0)}, {square(11.0625)}}), lower).size(), 1U);
}

TEST(MovedOverlap, DoesNotMindMotionsOfOtherCriteria) {
  const std::vector<RegionMotion> nowhere{motion(7, false, 0, 1)};
  const auto expected = checking::expected_partition(apart(), apart(), plain(), {{}, nowhere});
  ASSERT_TRUE(expected.ok());
  EXPECT_TRUE(expected->wrong_motions.empty());
}

TEST(MovedOverlap, FindsMotionsAnew) {
  const SectionStack stack =
      stack_of({{square(0, 4)}, {square(6, 4)}, {square(12, 4)}, {square(18, 4)}}, 8);
  const auto against = [&](const std::vector<RegionMotion>& motions) {
    const auto expected = checking::expected_partition(stack, stack, moved(), {{}, motions}, true);
    EXPECT_TRUE(expected.ok());
    return expected->other_motions.size();
  };
  std::vector<RegionMotion> right;
  for (const auto& [passage, by] :
       checking::estimated_motions(stack, checking::number_regions(stack))) {
    const std::size_t slab = passage.region - (passage.up ? 0 : 1);
    right.push_back({SlabId(slab), !passage.up, ContourId(0), by});
  }
  ASSERT_EQ(right.size(), 6U);
  EXPECT_NEAR(right[0].by.x, 6, 1);
  EXPECT_EQ(against(right), 0U);
  EXPECT_EQ(against({right[0]}), 5U);
  EXPECT_EQ(against({}), 0U);
  EXPECT_EQ(classes(stack, moved()), (Classes{0, 0, 0, 0}));
  std::vector<RegionMotion> other = right;
  other[2].by.y = std::nextafter(other[2].by.y, 1.0);
  EXPECT_EQ(against(other), 1U);
  other = right;
  other.pop_back();
  EXPECT_EQ(against(other), 1U);
}

// Decisions.

CorrespondenceOptions decided(std::uint32_t slab, std::uint32_t lower, std::uint32_t upper,
                              bool join, CorrespondenceOptions options = plain()) {
  options.decisions.push_back({SlabId(slab), ContourId(lower), ContourId(upper), join});
  return options;
}

TEST(Decisions, PartAndJoinPairs) {
  const SectionStack pillar = stack_of({{square(0)}, {square(0)}});
  EXPECT_EQ(classes(pillar, decided(0, 0, 0, false)), (Classes{0, 1}));
  EXPECT_EQ(classes(stack_of({{square(0)}, {square(90)}}), decided(0, 0, 0, true)),
            (Classes{0, 0}));
  const SectionStack lone = stack_of({{square(0)}, {square(10.25)}});
  EXPECT_EQ(classes(lone, decided(0, 0, 0, false, with_lone())), (Classes{0, 1}));
  // By a hole they name the region around it.
  const SectionStack frame = stack_of({{square(0), box(1, 1, 9, 9)}, {square(90)}});
  EXPECT_EQ(classes(frame, decided(0, 1, 0, true)), (Classes{0, 0, 0}));
}

TEST(Decisions, AreRefusedWhereTheyContradictOrNameNothing) {
  const SectionStack stack = stack_of({{square(0)}, {square(0)}});
  const auto code = [&](const CorrespondenceOptions& options) {
    const auto expected = checking::expected_partition(stack, stack, options);
    return expected.ok() ? std::nullopt : std::optional(expected.error().code);
  };
  EXPECT_EQ(code(decided(0, 0, 0, true)), std::nullopt);
  EXPECT_EQ(code(decided(0, 0, 0, true, decided(0, 0, 0, true))), std::nullopt);
  const std::optional invalid(ErrorCode::invalid_input);
  EXPECT_EQ(code(decided(0, 0, 0, true, decided(0, 0, 0, false))), invalid);
  EXPECT_EQ(code(decided(1, 0, 0, true)), invalid);
  EXPECT_EQ(code(decided(0, 1, 0, true)), invalid);
  EXPECT_EQ(code(decided(0, 0, 1, false)), invalid);
  EXPECT_EQ(code(decided(0, 0, 0, true, labelled({{0, 0, 1}, {1, 0, 2}}))), invalid);
  EXPECT_EQ(code(decided(0, 0, 0, true, labelled({{0, 0, 1}, {1, 0, 1}}))), std::nullopt);
}

TEST(Decisions, ComeBeforeWhatOverlapsMore) {
  // The middle one lies over the lower, and is joined with the upper.
  const SectionStack stack = stack_of({{square(0)}, {square(0)}, {square(90)}});
  const auto labels = labelled({{0, 0, 1}, {2, 0, 2}});
  EXPECT_EQ(classes(stack, labels), (Classes{0, 0, 1}));
  EXPECT_EQ(classes(stack, decided(1, 0, 0, true, labels)), (Classes{0, 1, 1}));
}

TEST(Decisions, CloseWaysToLabels) {
  const SectionStack stack = stack_of({{square(0)}, {square(0), square(20)}, {square(0)}});
  const auto labels = labelled({{0, 0, 1}, {2, 0, 1}});
  // Around by the other one of the middle.
  EXPECT_EQ(classes(stack, labels), (Classes{0, 0, 1, 0}));
  EXPECT_EQ(classes(stack, decided(0, 0, 0, false, labels)), (Classes{0, 0, 0, 0}));
  const auto both = decided(0, 0, 1, false, decided(0, 0, 0, false, labels));
  const auto expected = checking::expected_partition(stack, stack, both);
  ASSERT_TRUE(expected.ok());
  EXPECT_EQ(expected->unrealised, std::optional<std::uint32_t>(1));
}

// Links that could not be realised.

RegionLink dropped(std::uint32_t slab, std::uint32_t lower, std::uint32_t upper) {
  RegionLink link{SlabId(slab), ContourId(lower), ContourId(upper)};
  link.fate = LinkFate::unrealisable;
  return link;
}

TEST(DroppedLinks, AreLeftOutAndCounted) {
  const SectionStack stack = stack_of({{square(0)}, {square(10.25)}, {square(10.25)}});
  RegionLink made = dropped(1, 0, 0);
  made.fate = LinkFate::made;
  const std::vector<RegionLink> links{dropped(0, 0, 0), made};
  const auto expected = checking::expected_partition(stack, stack, with_lone(), {links, {}});
  ASSERT_TRUE(expected.ok());
  EXPECT_EQ(expected->dropped, 1U);
  EXPECT_TRUE(expected->wrong_dropped.empty());
  EXPECT_EQ(testing::classes_of(*expected), (Classes{0, 1, 1}));
}

TEST(DroppedLinks, AreCandidatesOfRegionsApartThatNobodyAskedFor) {
  const SectionStack stack = stack_of({{square(0)}, {square(10.25)}, {square(10.25), square(30)}});
  const auto wrong = [&](const std::vector<RegionLink>& links,
                         const CorrespondenceOptions& options = with_lone()) {
    const auto expected = checking::expected_partition(stack, stack, options, {links, {}});
    EXPECT_TRUE(expected.ok());
    return expected->wrong_dropped.size();
  };
  EXPECT_EQ(wrong({dropped(0, 0, 0)}), 0U);
  EXPECT_EQ(wrong({dropped(0, 0, 0), dropped(0, 0, 0)}), 1U);
  EXPECT_EQ(wrong({dropped(0, 0, 0)}, plain()), 1U);  // no candidate
  EXPECT_EQ(wrong({dropped(1, 0, 1)}), 1U);           // nor this
  EXPECT_EQ(wrong({dropped(1, 0, 0)}), 1U);           // the regions meet
  EXPECT_EQ(wrong({dropped(0, 0, 0)}, decided(0, 0, 0, true, with_lone())), 1U);
  EXPECT_EQ(wrong({dropped(2, 0, 0)}), 1U);
  EXPECT_EQ(wrong({dropped(0, 0, 1)}), 1U);
  EXPECT_EQ(wrong({dropped(0, 1, 0)}), 1U);
}

TEST(DroppedLinks, LeadNoLabel) {
  const SectionStack stack = stack_of({{square(0)}, {square(10.25)}});
  const std::vector<RegionLink> links{dropped(0, 0, 0)};
  const auto expected = checking::expected_partition(
      stack, stack, labelled({{0, 0, 1}, {1, 0, 1}}, with_lone()), {links, {}});
  ASSERT_TRUE(expected.ok());
  EXPECT_EQ(expected->unrealised, std::optional<std::uint32_t>(1));
}

}  // namespace
}  // namespace tetloft
