// Links of voids by the rule of voids.hpp as check recomputes it, and what it believes of a model's
// claims about them: case by case.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "check/void_links.hpp"
#include "unit/check/rule_stacks.hpp"

namespace tetloft {

using namespace internal;
namespace {

using checking::Link;
using checking::StackVoids;
using testing::box;
using testing::plate;
using testing::stack_of;

constexpr ContourId kOutside;

// Voids of two sections, by (lower, upper): 0 is the exterior, holes go by their lowest vertices.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs links_of_slab(const SectionStack& stack, const VoidOptions& options = {},
                    const std::vector<VoidLink>& claims = {}, std::size_t slab = 0) {
  const StackVoids voids(stack);
  const auto expected = checking::expected_voids(voids, voids.faces(), {}, options, claims);
  EXPECT_TRUE(expected.ok());
  if (!expected.ok()) return {};
  EXPECT_EQ(expected->wrong, std::vector<std::string>());
  Pairs pairs;
  const auto& first = voids.voids().first;
  for (const Link& link : expected->links) {
    if (voids.voids().section[link.lower] != slab) continue;
    pairs.emplace_back(link.lower - first[slab], link.upper - first[slab + 1]);
  }
  for (const checking::SlabVoids& forced : expected->forced) {
    if (forced.slab != slab) continue;
    pairs.emplace_back(forced.voids.lower - first[slab], forced.voids.upper - first[slab + 1]);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(VoidLinks, HoleOverHole) {
  EXPECT_EQ(links_of_slab(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(6, 6, 10, 10)}})),
            (Pairs{{0, 0}, {1, 1}}));
  // A corner of 1/64 of either is too little; of a sixteenth it is not, whatever else there is.
  EXPECT_EQ(
      links_of_slab(stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(8.5, 8.5, 12.5, 12.5)}})),
      (Pairs{{0, 0}}));
  EXPECT_EQ(links_of_slab(stack_of({{plate(), box(1, 5, 5, 9), box(6, 5, 10, 9)},
                                    {plate(), box(1, 5, 5, 9), box(5.5, 5, 9.5, 9)}})),
            (Pairs{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(VoidLinks, ExteriorsAlwaysAndHolesByTheirShareOutside) {
  EXPECT_EQ(links_of_slab(stack_of({{}, {plate()}})), (Pairs{{0, 0}}));
  // The upper plate covers all of the hole but a quarter, or nothing of it.
  EXPECT_EQ(links_of_slab(stack_of({{plate(), box(5, 5, 9, 9)}, {box(6, 0, 20, 20)}})),
            (Pairs{{0, 0}, {1, 0}}));
  EXPECT_EQ(links_of_slab(stack_of({{plate(), box(5, 5, 9, 9)}, {}})), (Pairs{{0, 0}, {1, 0}}));
  EXPECT_EQ(links_of_slab(stack_of({{plate(), box(5, 5, 9, 9)}, {plate()}})), (Pairs{{0, 0}}));
}

TEST(VoidLinks, AnIslandIsNotPartOfTheHole) {
  const std::vector<Contour> island{plate(), box(4, 4, 16, 16), box(5, 5, 15, 15)};
  EXPECT_EQ(links_of_slab(stack_of({island, {plate(), box(6, 6, 8, 8)}})), (Pairs{{0, 0}}));
}

TEST(VoidLinks, ChainsMoveOnFromAHoleButNotFromTheExterior) {
  const auto at = [](double x) { return std::vector<Contour>{plate(), box(x, 9, x + 2, 11)}; };
  // Always 2.5 apart: by motion on alone.
  const SectionStack straight = stack_of({at(2), at(4.5), at(7)}, 1);
  EXPECT_EQ(links_of_slab(straight, {}, {}, 1), (Pairs{{0, 0}, {1, 1}}));
  const SectionStack bent = stack_of({at(2), at(4.5), at(2)}, 1);
  EXPECT_EQ(links_of_slab(bent, {}, {}, 1), (Pairs{{0, 0}}));
  // More than a gap apart.
  const SectionStack far = stack_of({at(2), at(5.5), at(9)}, 1);
  EXPECT_EQ(links_of_slab(far, {}, {}, 1), (Pairs{{0, 0}}));
  // The middle hole is linked to the exterior beneath, its only partner there.
  const SectionStack from_outside = stack_of({{box(8, 0, 20, 20)}, at(4.5), at(7)}, 1);
  EXPECT_EQ(links_of_slab(from_outside, {}, {}, 1), (Pairs{{0, 0}}));
}

TEST(VoidLinks, RimsAndTheNearest) {
  // 0.5 from the upper plate's side, under it.
  const auto stack = [](double gap) {
    return stack_of({{plate(), box(5, 5, 9, 9)}, {box(4.5, 0, 20, 20)}}, gap);
  };
  EXPECT_EQ(links_of_slab(stack(2.25)), (Pairs{{0, 0}, {1, 0}}));
  EXPECT_EQ(links_of_slab(stack(2)), (Pairs{{0, 0}}));
  VoidOptions options;
  options.rule = VoidRule::near;
  EXPECT_EQ(links_of_slab(stack(2), options), (Pairs{{0, 0}, {1, 0}}));
  EXPECT_EQ(links_of_slab(stack(1), options), (Pairs{{0, 0}}));
  options.reach = 0;
  EXPECT_EQ(links_of_slab(stack(2.25), options), (Pairs{{0, 0}}));
  // To a hole, and of two to the nearer.
  const SectionStack holes =
      stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(2, 5, 4, 9), box(9.5, 5, 12, 9)}}, 4);
  EXPECT_EQ(links_of_slab(holes), (Pairs{{0, 0}}));
  options.reach = 0.5;
  EXPECT_EQ(links_of_slab(holes, options), (Pairs{{0, 0}, {1, 1}, {1, 2}}));
  options.reach = 0.2;
  EXPECT_EQ(links_of_slab(holes, options), (Pairs{{0, 0}, {1, 2}}));
}

TEST(VoidLinks, DecisionsAndLabels) {
  const SectionStack stack = stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(6, 6, 10, 10)}});
  VoidOptions options;
  options.decisions = {{SlabId(0U), ContourId(1U), ContourId(1U), false},
                       {SlabId(0U), ContourId(1U), kOutside, true}};
  EXPECT_EQ(links_of_slab(stack, options), (Pairs{{0, 0}, {1, 0}}));
  options.decisions.clear();
  options.labels = {{SectionId(0U), ContourId(1U), 1}, {SectionId(1U), ContourId(1U), 2}};
  EXPECT_EQ(links_of_slab(stack, options), (Pairs{{0, 0}}));
  // Two holes of one label, of which nothing else says that they belong together.
  const SectionStack apart = stack_of({{plate(), box(1, 1, 4, 4)}, {plate(), box(15, 15, 18, 18)}});
  options.labels[1].label = 1;
  EXPECT_EQ(links_of_slab(apart, options), (Pairs{{0, 0}, {1, 1}}));
}

TEST(VoidLinks, RefusesWhatNamesNoHole) {
  const StackVoids stack(stack_of({{plate(), box(5, 5, 9, 9)}, {plate()}}));
  const auto refused = [&](const VoidOptions& options) {
    const auto expected = checking::expected_voids(stack, stack.faces(), {}, options, {});
    return !expected.ok() && expected.error().code == ErrorCode::invalid_input;
  };
  const auto decision = [](ContourId lower, ContourId upper, bool join) {
    return LinkDecision{SlabId(0U), lower, upper, join};
  };
  EXPECT_FALSE(refused({}));
  for (const std::uint32_t contour : {0U, 2U, 7U}) {
    EXPECT_TRUE(refused({.labels = {{SectionId(0U), ContourId(contour), 1}}})) << contour;
    EXPECT_TRUE(refused({.decisions = {decision(ContourId(contour), kOutside, true)}})) << contour;
  }
  EXPECT_TRUE(refused({.labels = {{SectionId(2U), ContourId(1U), 1}}}));
  EXPECT_TRUE(refused({.labels = {{SectionId(0U), kOutside, 1}}}));
  EXPECT_TRUE(refused({.decisions = {decision(kOutside, kOutside, true)}}));
  EXPECT_TRUE(refused({.decisions = {decision(ContourId(1U), kOutside, true),
                                     decision(ContourId(1U), kOutside, false)}}));
  EXPECT_TRUE(
      refused({.labels = {{SectionId(0U), ContourId(1U), 1}, {SectionId(0U), ContourId(1U), 2}}}));
}

VoidLink claim(ContourId lower, ContourId upper, LinkFate fate) {
  VoidLink link;
  link.slab = SlabId(0U);
  link.lower = lower;
  link.upper = upper;
  link.fate = fate;
  return link;
}

TEST(VoidLinks, BelievesWhatMayBe) {
  const SectionStack stack =
      stack_of({{plate(), box(5, 5, 9, 9)}, {plate(), box(6, 6, 10, 10), box(15, 15, 17, 17)}});
  const ContourId one(1U);
  const ContourId two(2U);
  const VoidLink sealed = claim(one, one, LinkFate::unrealisable);
  const VoidLink forced = claim(one, two, LinkFate::forced);
  EXPECT_EQ(links_of_slab(stack, {}, {sealed}), (Pairs{{0, 0}}));
  EXPECT_EQ(links_of_slab(stack, {}, {forced}), (Pairs{{0, 0}, {1, 1}, {1, 2}}));
  const StackVoids voids(stack);
  const auto wrong = [&](const std::vector<VoidLink>& claims) {
    return checking::expected_voids(voids, voids.faces(), {}, {}, claims)->wrong.size();
  };
  EXPECT_EQ(wrong({sealed, forced}), 0U);
  EXPECT_EQ(wrong({sealed, sealed, forced, forced}), 2U);
  EXPECT_EQ(wrong({claim(one, two, LinkFate::unrealisable)}), 1U);
  EXPECT_EQ(wrong({claim(one, one, LinkFate::forced)}), 1U);
  EXPECT_EQ(wrong({claim(kOutside, kOutside, LinkFate::forced)}), 1U);
  EXPECT_EQ(wrong({claim(kOutside, kOutside, LinkFate::unrealisable)}), 1U);
  EXPECT_EQ(wrong({claim(ContourId(0U), one, LinkFate::forced)}), 1U);
  EXPECT_EQ(wrong({claim(one, ContourId(3U), LinkFate::forced)}), 1U);
  VoidLink nowhere = forced;
  nowhere.slab = SlabId(1U);
  EXPECT_EQ(wrong({nowhere}), 1U);
  EXPECT_EQ(wrong({claim(one, kOutside, LinkFate::too_weak)}), 0U);
}

}  // namespace
}  // namespace tetloft
