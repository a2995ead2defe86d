// Links of voids: V1 to V3 of the rule.
#include "correspondence/void_links.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <tetloft/links.hpp>
#include <tetloft/overlap.hpp>

#include "core/prng.hpp"
#include "sections/complement.hpp"
#include "spatial/box_tree.hpp"
#include "support/slabs/cases.hpp"
#include "void_links_of.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

const Contour kOutline = box(-100, -100, 100, 100);

// Sections of one outline with holes, a gap of 10 apart.
SectionStack block(const std::vector<std::vector<Contour>>& holes) {
  std::vector<std::vector<Contour>> sections;
  for (const std::vector<Contour>& of_section : holes) {
    sections.push_back({kOutline});
    sections.back().insert(sections.back().end(), of_section.begin(), of_section.end());
  }
  SectionStack stack = stack_of_boxes(sections);
  for (Section& section : stack.sections) section.z *= 10;
  return stack;
}

// Between sections without holes.
SectionStack capped(SectionStack stack) {
  SectionStack result;
  result.sections.push_back({-10, IdVector<ContourId, Contour>({kOutline})});
  for (Section& section : stack.sections) result.sections.push_back(std::move(section));
  const double last = 10 * static_cast<double>(stack.sections.size());
  result.sections.push_back({last, IdVector<ContourId, Contour>({kOutline})});
  return result;
}

Contour hole_at(double x, double half = 2) { return box(x - half, -half, x + half, half); }

TEST(VoidLinks, OverlapAbove2Percent) {
  // Holes of 10 x 10, of which 2, and a little more, overlap: the double 0.02 is above 1/50.
  const auto two = [](double y) {
    return block({{box(0, 0, 10, 10)}, {box(9, 10 - y, 19, 20 - y)}});
  };
  EXPECT_EQ(told(two(2)), (Told{{0, 1, 1, Evidence::overlap, LinkFate::too_weak}}));
  EXPECT_EQ(told(two(2.001)), (Told{{0, 1, 1, Evidence::overlap, LinkFate::made}}));
  EXPECT_EQ(told(two(0)), Told{});
  EXPECT_EQ(cavities_of(capped(two(2))), 2U);
  EXPECT_EQ(cavities_of(capped(two(2.001))), 1U);
}

TEST(VoidLinks, HolesOfTheFirstAndLastSectionAreNoCavities) {
  const SectionStack stack = block({{hole_at(0)}, {hole_at(10)}, {hole_at(20), hole_at(12)}});
  EXPECT_EQ(cavities_of(stack), 0U);  // the one in the middle overlaps one of the last section
  EXPECT_EQ(cavities_of(block({{hole_at(0)}, {hole_at(20)}, {hole_at(0)}})), 1U);
  EXPECT_EQ(cavities_of(block({{hole_at(0)}, {hole_at(0)}, {hole_at(20)}})), 0U);
  EXPECT_EQ(cavities_of(capped(stack)), 3U);
}

TEST(VoidLinks, KnowNoGuard) {
  // The first hole below and the second above each have a better partner.
  const SectionStack across =
      block({{box(0, 0, 10, 10), box(11, 0, 21, 10)}, {box(0, 0, 8, 10), box(9.5, 0, 21, 10)}});
  EXPECT_EQ(made(across), (Pairs3{{0, 1, 1}, {0, 1, 2}, {0, 2, 2}}));
}

TEST(VoidLinks, TheExteriorIsInfinite) {
  // A hole under an outline that ends within it, and one wholly outside: the share of the hole
  // counts, however small what is left of the exterior's own sides.
  const auto under = [](double edge) {
    return stack_of_boxes({{kOutline, box(0, 0, 10, 10)}, {box(-100, -100, edge, 100)}});
  };
  const auto link = [](const SectionStack& stack) { return found_links(stack).void_links.at(0); };
  EXPECT_EQ(link(under(5)).ratio, 0.5);
  EXPECT_EQ(link(under(-50)).ratio, 1);
  EXPECT_NEAR(link(under(9.75)).ratio, 0.025, 1e-9);
  for (const double edge : {5.0, -50.0, 9.75}) {
    EXPECT_EQ(told(under(edge)), (Told{{0, 1, kOutside, Evidence::overlap, LinkFate::made}}));
    EXPECT_EQ(told(upside_down(under(edge))),
              (Told{{0, kOutside, 1, Evidence::overlap, LinkFate::made}}));
    EXPECT_EQ(cavities_of(capped(under(edge))), 0U);
  }
}

TEST(VoidLinks, OfAnEmptySectionIsTheExteriorAlone) {
  SectionStack stack = block({{hole_at(0)}, {hole_at(0)}});
  stack.sections[SectionId(1)].contours.clear();
  EXPECT_EQ(told(stack), (Told{{0, 1, kOutside, Evidence::overlap, LinkFate::made}}));
}

TEST(VoidLinks, HolesAreTakenWithoutTheirIslands) {
  // The hole above lies in the island.
  const auto stack = [](double half) {
    return block({{hole_at(0, 20), hole_at(0, 10)}, {hole_at(0, half)}});
  };
  EXPECT_EQ(made(stack(9)), Pairs3{});
  EXPECT_EQ(made(stack(11)), (Pairs3{{0, 1, 1}}));
}

TEST(VoidLinks, AreNoneWithoutHolesOrByFree) {
  CorrespondenceOptions free;
  free.voids.rule = VoidRule::free;
  const SectionStack stack = block({{hole_at(0)}, {hole_at(0)}});
  EXPECT_EQ(made(stack), (Pairs3{{0, 1, 1}}));
  EXPECT_EQ(told(stack, free), Told{});
  EXPECT_EQ(cavities_of(capped(stack), free), 0U);
  EXPECT_EQ(told(block({{}, {}})), Told{});
  EXPECT_EQ(cavities_of(block({{}, {}})), 0U);
}

// Tunnels that lean: holes of side 4, moving by 5 a section.
TEST(VoidLinks, ChainsGoOnFromTheNearestHoleBeyond) {
  const SectionStack stack = block({{hole_at(0)}, {hole_at(5)}, {hole_at(10)}, {hole_at(15)}});
  EXPECT_EQ(told(stack), (Told{{0, 1, 1, Evidence::chain, LinkFate::made},
                               {1, 1, 1, Evidence::chain, LinkFate::made},
                               {2, 1, 1, Evidence::chain, LinkFate::made}}));
  // Two sections tell no direction; nor do those that move on elsewhere.
  EXPECT_EQ(told(block({{hole_at(0)}, {hole_at(5)}})), Told{});
  EXPECT_EQ(made(block({{hole_at(0)}, {hole_at(5)}, {hole_at(-1)}})), Pairs3{});
}

TEST(VoidLinks, ChainsGoOnFromTheOnlyPartner) {
  // From one that overlaps: by 3, then by 4.5.
  const SectionStack stack = block({{hole_at(0)}, {hole_at(3)}, {hole_at(7.5)}});
  EXPECT_EQ(told(stack), (Told{{0, 1, 1, Evidence::overlap, LinkFate::made},
                               {1, 1, 1, Evidence::chain, LinkFate::made}}));
  // Of two that overlap there is no telling.
  EXPECT_EQ(made(block({{hole_at(0), box(4, -2, 6, 2)}, {hole_at(3)}, {hole_at(7.5)}})),
            (Pairs3{{0, 1, 1}, {0, 2, 1}}));
}

TEST(VoidLinks, ChainsReachAGap) {
  EXPECT_EQ(made(block({{hole_at(0)}, {hole_at(14)}, {hole_at(28)}})).size(), 2U);
  EXPECT_EQ(made(block({{hole_at(0)}, {hole_at(14.5)}, {hole_at(29)}})), Pairs3{});
}

TEST(VoidLinks, TheExteriorIsNoOriginAndNeverSingle) {
  // The hole in the middle lies partly outside the outline below, which ends the tunnel there:
  // nothing tells where it goes.
  SectionStack stack = block({{hole_at(0)}, {hole_at(5)}, {hole_at(10)}});
  EXPECT_EQ(made(stack).size(), 2U);
  stack.sections[SectionId(0)].contours = IdVector<ContourId, Contour>({box(-100, -100, 4, 100)});
  EXPECT_EQ(made(stack), (Pairs3{{0, kOutside, 1}}));
}

TEST(VoidLinks, RimsReachAQuarterOfAGap) {
  // A hole whose edge lies this far inside the outline above.
  const auto inside = [](double by) {
    SectionStack stack = block({{box(0, 0, 10, 10)}, {}});
    stack.sections[SectionId(1)].contours[ContourId(0)] = box(-100, -100, 10 + by, 100);
    return stack;
  };
  EXPECT_EQ(told(inside(2.4)), (Told{{0, 1, kOutside, Evidence::rim, LinkFate::made}}));
  EXPECT_EQ(told(inside(2.5)), (Told{{0, 1, kOutside, Evidence::rim, LinkFate::too_weak}}));
  EXPECT_EQ(told(inside(10)), (Told{{0, 1, kOutside, Evidence::rim, LinkFate::too_weak}}));
  EXPECT_EQ(told(inside(10.1)), Told{});
  EXPECT_EQ(told(upside_down(inside(2.4))),
            (Told{{0, kOutside, 1, Evidence::rim, LinkFate::made}}));
  const VoidLink link = found_links(inside(2.5)).void_links.at(0);
  EXPECT_EQ(link.distance, 0.25);
  EXPECT_EQ(link.margin, 0);
}

TEST(VoidLinks, ARimIsForHolesWithoutLink) {
  // Near the outline, and over a hole.
  SectionStack stack = block({{box(0, 0, 10, 10)}, {box(0, 0, 10, 10)}});
  for (Section& section : stack.sections) section.contours[ContourId(0)] = box(-100, -100, 12, 100);
  EXPECT_EQ(told(stack), (Told{{0, 1, 1, Evidence::overlap, LinkFate::made}}));
  // One that overlaps the exterior by less than 2 % is at distance 0.
  SectionStack weak = block({{box(0, 0, 10, 10)}, {}});
  weak.sections[SectionId(1)].contours[ContourId(0)] = box(-100, -100, 9.9, 100);
  EXPECT_EQ(told(weak), (Told{{0, 1, kOutside, Evidence::rim, LinkFate::made}}));
  EXPECT_EQ(found_links(weak).void_links.at(0).ratio,
            overlap_ratio(RegionOutline{{&weak.sections[SectionId(0)].contours[ContourId(1)]}}, [] {
              static const Contour outside = box(9.9, -50, 50, 50);
              return RegionOutline{{&outside}};
            }()));
}

CorrespondenceOptions near(double reach) {
  CorrespondenceOptions options;
  options.voids.rule = VoidRule::near;
  options.voids.reach = reach;
  return options;
}

TEST(VoidLinks, NearReachesTheNearestVoid) {
  const SectionStack stack = block({{hole_at(0)}, {hole_at(8), hole_at(-9)}});
  EXPECT_EQ(told(stack), Told{});
  // Four apart, and five; each takes what is nearest to it.
  EXPECT_EQ(told(stack, near(0.45)), (Told{{0, 1, 2, Evidence::rim, LinkFate::too_weak},
                                           {0, 1, 1, Evidence::rim, LinkFate::made}}));
  EXPECT_EQ(made(stack, near(0.55)), (Pairs3{{0, 1, 1}, {0, 1, 2}}));
  // Less than the reach, not equal.
  EXPECT_EQ(made(stack, near(0.4)), Pairs3{});
  EXPECT_EQ(cavities_of(capped(stack), near(0.45)), 2U);
}

TEST(VoidLinks, NearTakesTheExteriorWhereThatIsNearest) {
  SectionStack stack = block({{box(0, 0, 10, 10)}, {box(-8, 0, -4, 4)}});
  EXPECT_EQ(made(stack, near(0.5)), (Pairs3{{0, 1, 1}}));
  stack.sections[SectionId(1)].contours[ContourId(0)] = box(-100, -100, 13, 100);
  EXPECT_EQ(made(stack, near(0.5)), (Pairs3{{0, 1, 1}, {0, 1, kOutside}}));
  // As near as the hole: the exterior has the lowest number.
  stack.sections[SectionId(1)].contours[ContourId(0)] = box(-100, -100, 14, 100);
  const auto of_lower = [](const SectionStack& s) { return made(s, near(0.5)); };
  EXPECT_EQ(of_lower(stack), (Pairs3{{0, 1, 1}, {0, 1, kOutside}}));
}

TEST(VoidLinks, NearOfNothingLinksNothing) {
  SectionStack stack = block({{hole_at(0)}, {hole_at(4)}});  // touching
  EXPECT_EQ(made(stack, near(0)), Pairs3{});
  stack.sections[SectionId(1)].contours[ContourId(0)] = box(-100, -100, 2, 100);
  stack.sections[SectionId(1)].contours.resize(1);
  EXPECT_EQ(made(stack), (Pairs3{{0, 1, kOutside}}));
  EXPECT_EQ(made(stack, near(0)), Pairs3{});
}

TEST(VoidLinks, LeadsAreOverOtherPairsOfTheHoles) {
  // Two holes under an outline that ends within both: the exterior's other pair is no rival.
  const SectionStack apart = stack_of_boxes(
      {{kOutline, box(0, 0, 10, 10), box(0, 20, 10, 30)}, {box(-100, -100, 5, 100)}});
  for (const VoidLink& link : found_links(apart).void_links) EXPECT_FALSE(link.lead);
  // A hole that overlaps the exterior by a half, and another hole by a quarter.
  const SectionStack both = stack_of_boxes(
      {{kOutline, box(0, 0, 10, 10)}, {box(-100, -100, 5, 100), box(0, 0, 2.5, 10)}});
  const auto links = found_links(both).void_links;
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].lead, 0.5 - 1.0);
  EXPECT_EQ(links[1].lead, 1.0 - 0.5);
}

// Blocks with an outline that comes and goes, and holes in cells of 10, some with islands; on a
// lattice of quarters, so that edges run along each other.
SectionStack random_block(Prng& prng) {
  const auto pick = [&](double least, double most) {
    return least +
           static_cast<double>(prng.below(static_cast<std::uint64_t>(4 * (most - least)))) / 4;
  };
  std::vector<std::vector<Contour>> sections(2 + prng.below(3));
  for (std::vector<Contour>& contours : sections) {
    const Box2 outline{pick(-12, 6), pick(-12, 6), pick(34, 52), pick(34, 52)};
    if (prng.below(8) != 0 || &contours == &sections.front())
      contours.push_back(box(outline.x0, outline.y0, outline.x1, outline.y1));
    for (std::uint64_t cell = 0; cell < 16 && !contours.empty(); ++cell) {
      const double x = 10 * static_cast<double>(cell % 4) + pick(0.25, 4);
      const double y = 10 * static_cast<double>(cell / 4) + pick(0.25, 4);
      const double w = pick(1.5, 5.5);
      const double h = pick(1.5, 5.5);
      const bool fits =
          x > outline.x0 && y > outline.y0 && x + w < outline.x1 && y + h < outline.y1;
      if (prng.below(2) == 0 || !fits) continue;
      contours.push_back(box(x, y, x + w, y + h));
      if (prng.below(4) == 0) contours.push_back(box(x + 0.25, y + 0.5, x + w - 0.5, y + h - 0.25));
    }
  }
  SectionStack stack = stack_of_boxes(sections);
  for (Section& section : stack.sections) section.z *= 6;
  return stack;
}

struct Counts {
  std::size_t overlaps = 0, rims = 0;
};

void expect_those_of_all(const SectionStack& stack, const CorrespondenceOptions& options,
                         Counts& counts) {
  const StackLinks found = found_links(stack, options);
  const Voids voids(stack);
  for (const SlabId slab : IdRange<SlabId>(stack.sections.size() - 1)) {
    expect_overlaps_of_all(voids, slab, found, counts.overlaps);
    expect_rims_of_all(voids, slab, found, options.voids, counts.rims);
  }
}

// All ratios and distances against those of whole complements.
TEST(VoidLinks, AreThoseOfTheWholeComplements) {
  Counts counts;
  Counts by_near;
  Prng prng(6101);
  for (int trial = 0; trial < 60; ++trial) {
    const SectionStack stack = random_block(prng);
    expect_those_of_all(stack, {}, counts);
    expect_those_of_all(stack, near(0.125 * static_cast<double>(prng.below(12))), by_near);
  }
  EXPECT_GT(counts.overlaps, 500U);
  EXPECT_GT(counts.rims, 50U);
  EXPECT_GT(by_near.rims, 200U);
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 6102).stack;
    if (stack.vertex_count() > 3000) continue;
    SCOPED_TRACE(name_of(kind));
    expect_those_of_all(stack, {}, counts);
  }
}

TEST(VoidLinks, ScaleWithTheStackAndDoNotDependOnThreadsOrOrder) {
  Prng prng(6103);
  for (int trial = 0; trial < 40; ++trial) {
    const SectionStack stack = random_block(prng);
    const Told one = told(stack);
    SectionStack large = stack;
    SectionStack turned = stack;
    for (const SectionId s : stack.sections.ids()) {
      large.sections[s].z = std::ldexp(stack.sections[s].z, 200);
      for (Contour& contour : large.sections[s].contours) {
        for (Point2& p : contour.vertices) p = {std::ldexp(p.x, 200), std::ldexp(p.y, 200)};
      }
      auto& contours = turned.sections[s].contours;
      std::reverse(contours.begin(), contours.end());
      for (Contour& contour : contours) {
        std::rotate(contour.vertices.begin(), contour.vertices.begin() + 1, contour.vertices.end());
      }
    }
    EXPECT_EQ(told(large), one);
    Told renamed = told(turned);
    for (auto& [slab, lower, upper, evidence, fate] : renamed) {
      const auto rename = [&](std::size_t s, std::size_t c) {
        return c == kOutside ? c : stack.sections[SectionId(s)].contours.size() - 1 - c;
      };
      lower = rename(slab, lower);
      upper = rename(slab + 1, upper);
    }
    EXPECT_EQ(renamed, one);
    EXPECT_EQ(told(stack, {}, 3), one);
  }
}

}  // namespace
}  // namespace tetloft::testing
