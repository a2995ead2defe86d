// Chains: oblique parts whose neighbouring sections do not overlap.
#include "correspondence/chain_links.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

CorrespondenceOptions chains_alone() {
  CorrespondenceOptions options;
  options.criterion = Criterion::overlap;
  options.lone = false;
  return options;
}

Pairs chained(const SectionStack& stack, std::size_t slab) {
  return links_of(stack, slab, chains_alone(), Evidence::chain);
}

Contour disc(double x, double y, int corners = 16) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    contour.vertices.push_back({x + std::cos(angle), y + std::sin(angle)});
  }
  return contour;
}

SectionStack tube(const std::vector<std::pair<double, double>>& at) {
  SectionStack stack;
  for (const auto& [x, z] : at) stack.sections.push_back({z, {}});
  for (const SectionId s : stack.sections.ids()) {
    stack.sections[s].contours.push_back(disc(at[s.index()].first, at[s.index()].first / 4));
  }
  return stack;
}

// Three squares of side 40: one, the next shifted by 20, the last by `step`; gaps of 10, then
// `gap`.
SectionStack squares(double step, double gap = 10) {
  SectionStack stack = stack_of_boxes(
      {{box(0, 0, 40, 40)}, {box(20, 0, 60, 40)}, {box(20 + step, 0, 60 + step, 40)}});
  stack.sections[SectionId(1)].z = 10;
  stack.sections[SectionId(2)].z = 10 + gap;
  return stack;
}

TEST(ChainLinks, GoOnAsTheyCame) {
  // The second slab goes on as the first, which overlaps; the others as the nearest beyond.
  const SectionStack stack = tube({{0, 0}, {1.5, 1}, {3.6, 2}, {5.8, 3}, {8.2, 4}});
  EXPECT_EQ(chained(stack, 0), Pairs{});
  for (std::size_t k = 1; k < 4; ++k) EXPECT_EQ(chained(stack, k), (Pairs{{0, 0}})) << k;
  EXPECT_EQ(components_by(stack, chains_alone()), 1U);
  EXPECT_EQ(components_by(upside_down(stack), chains_alone()), 1U);
  CorrespondenceOptions without = chains_alone();
  without.chain = false;
  EXPECT_EQ(components_by(stack, without), 4U);
}

TEST(ChainLinks, NeedNoOverlapToStartFrom) {
  const SectionStack stack = tube({{0, 0}, {2.5, 1}, {5, 2}, {7.5, 3}});
  EXPECT_EQ(components_by(stack, chains_alone()), 1U);
  // Two sections tell no direction.
  EXPECT_EQ(components_by(tube({{0, 0}, {2.5, 1}}), chains_alone()), 2U);
}

TEST(ChainLinks, ReachTwoGaps) {
  // Discs of radius 1 at distance 2 + d.
  EXPECT_EQ(components_by(tube({{0, 0}, {3.8, 1}, {7.6, 2}}), chains_alone()), 1U);
  EXPECT_EQ(components_by(tube({{0, 0}, {4.2, 1}, {8.4, 2}}), chains_alone()), 3U);
}

TEST(ChainLinks, ARatioOfExactlyATenthDoesNotUnite) {
  // Moved by 20 the middle square reaches 80; the double 1/10 is a little more than a tenth.
  EXPECT_EQ(chained(squares(56), 1), Pairs{});
  EXPECT_EQ(chained(squares(55), 1), (Pairs{{0, 0}}));
  const auto link = link_between(squares(55), 1, 0, 0, chains_alone());
  ASSERT_TRUE(link);
  EXPECT_EQ(link->moved, 0.125);
  EXPECT_EQ(link->ratio, 0);
  EXPECT_EQ(link->distance, 1.5);
  EXPECT_EQ(link->margin, 0.125 - kChainOverlap);
}

TEST(ChainLinks, MoveInProportionToTheGaps) {
  EXPECT_EQ(chained(squares(80, 10), 1), Pairs{});
  EXPECT_EQ(chained(squares(80, 40), 1), (Pairs{{0, 0}}));
  EXPECT_EQ(chained(squares(80, 90), 1), Pairs{});
  EXPECT_EQ(chained(upside_down(squares(80, 40)), 0), (Pairs{{0, 0}}));
}

TEST(ChainLinks, RegionsOfTwoCandidatesHaveNoOrigin) {
  SectionStack stack = squares(50);
  EXPECT_EQ(chained(stack, 1), (Pairs{{0, 0}}));
  stack.sections[SectionId(0)].contours.push_back(box(50, 0, 90, 40));
  EXPECT_EQ(chained(stack, 1), Pairs{});
}

TEST(ChainLinks, RegionsWithACandidateInTheSlabAreLeftAlone) {
  // What lies above is covered already: by a second region below.
  SectionStack stack = squares(50);
  stack.sections[SectionId(1)].contours.push_back(box(80, 0, 120, 40));
  EXPECT_EQ(chained(stack, 1), Pairs{});
}

TEST(ChainLinks, OfEquallyNearOriginsTheLowerNumberCounts) {
  // Two discs below, as far to the left as to the right: regions are numbered from the left.
  SectionStack stack = tube({{0, 0}, {3, 1}, {6, 2}});
  stack.sections[SectionId(0)].contours.push_back(disc(6, 6.0 / 4));
  stack.sections[SectionId(0)].contours[ContourId(0)] = disc(0, 0);
  stack.sections[SectionId(1)].contours[ContourId(0)] = disc(3, 3.0 / 4);
  EXPECT_EQ(chained(stack, 1), (Pairs{{0, 0}}));
}

TEST(ChainLinks, HolesMoveWithTheirRegions) {
  // The frame moved on surrounds the small square above without meeting it.
  const std::vector<Contour> low{box(0, 0, 8, 8), box(1, 1, 7, 7)};
  const std::vector<Contour> high{box(5, 0, 13, 8), box(6, 1, 12, 7)};
  EXPECT_EQ(chained(stack_of_boxes({low, high, {box(13.5, 3, 15, 5)}}), 1), Pairs{});
  EXPECT_EQ(chained(stack_of_boxes({low, high, {box(13.5, 3, 17.5, 5)}}), 1), (Pairs{{0, 0}}));
}

TEST(ChainLinks, CoordinatesOfAnySizeDoNotFail) {
  for (const double s : {0x1p-500, 0x1p980}) {
    SectionStack stack = squares(50);
    for (Section& section : stack.sections) {
      section.z *= s;
      for (Contour& contour : section.contours) {
        for (Point2& p : contour.vertices) p = {s * p.x, s * p.y};
      }
    }
    EXPECT_EQ(chained(stack, 1), (Pairs{{0, 0}})) << s;
  }
  // Moved by more than the numbers hold, which leaves no region.
  EXPECT_EQ(chained(squares(80, 0x1p990), 1), Pairs{});
  EXPECT_EQ(chained(squares(80, 0x1p100), 1), Pairs{});
}

}  // namespace
}  // namespace tetloft::testing
