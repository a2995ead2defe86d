// Links by overlap: exact ratios, and weak links beside strong ones.
#include "correspondence/overlap_links.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The overlap links of a stack's only slab, as pairs of regions.
Pairs overlap_pairs(const SectionStack& stack, double tau) {
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const StackSections sections = sections_of(stack, nestings);
  Pairs pairs;
  for (const LinkCandidate& candidate :
       overlap_links(SlabId(0), sections[SectionId(0)], sections[SectionId(1)], tau)) {
    EXPECT_EQ(candidate.link.slab, SlabId(0));
    if (!candidate.made()) continue;
    pairs.emplace_back(candidate.link.lower.index(), candidate.link.upper.index());
  }
  return pairs;
}

TEST(OverlapLinks, ARatioOfExactlyTauDoesNotUnite) {
  // Half of either square is shared.
  const SectionStack half = stack_of_boxes({{box(0, 0, 2, 2)}, {box(1, 0, 3, 2)}});
  EXPECT_EQ(overlap_pairs(half, 0.5), Pairs{});
  EXPECT_EQ(overlap_pairs(half, std::nextafter(0.5, 0.0)), (Pairs{{0, 0}}));
  // The double 1/5 is a little more than a fifth, so this ratio does not exceed it.
  const SectionStack fifth = stack_of_boxes({{box(0, 0, 5, 1)}, {box(4, 0, 9, 1)}});
  EXPECT_EQ(overlap_pairs(fifth, 0.2), Pairs{});
  EXPECT_EQ(overlap_pairs(fifth, std::nextafter(0.2, 0.0)), (Pairs{{0, 0}}));
}

TEST(OverlapLinks, RegionsThatOnlyTouchAreNotUnitedByAnyTau) {
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 1, 1)}, {box(1, 0, 2, 1)}}), 0), Pairs{});
}

TEST(OverlapLinks, WhatLiesInAHoleDoesNotOverlap) {
  EXPECT_EQ(
      overlap_pairs(stack_of_boxes({{box(0, 0, 9, 9), box(2, 2, 7, 7)}, {box(3, 3, 6, 6)}}), 0),
      Pairs{});
}

TEST(OverlapLinks, AWeakLinkBetweenTwoWellConnectedRegionsIsTakenForCoincidence) {
  const std::vector<Contour> above{box(0, 0, 2.5, 4), box(3.5, 0, 9, 4)};
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 4, 4), box(5, 0, 9, 4)}, above}), 0.02),
            (Pairs{{0, 0}, {1, 1}}));
  // Without the other link of the upper region the same weak link counts.
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 4, 4)}, above}), 0.02),
            (Pairs{{0, 0}, {0, 1}}));
}

TEST(OverlapLinks, ALinkOfExactlyOneQuarterIsStrong) {
  // Of the weak link's regions the upper one is well connected by a ratio of 1/4 exactly.
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(7, 0, 11, 4)}, {box(0, 0, 2.5, 4), box(3.5, 0, 8, 4)}});
  EXPECT_EQ(overlap_pairs(stack, 0.02), (Pairs{{0, 0}, {1, 1}}));
}

TEST(OverlapLinks, ALinkAboveOneQuarterIsNotOutruledByStrongerOnes) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(6, 0, 10, 4)}, {box(0, 0, 2.5, 4), box(2.8, 0, 8, 4)}});
  EXPECT_EQ(overlap_pairs(stack, 0.02), (Pairs{{0, 0}, {0, 1}, {1, 1}}));
}

}  // namespace
}  // namespace tetloft::testing
