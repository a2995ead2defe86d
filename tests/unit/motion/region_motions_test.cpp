#include "motion/region_motions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <tetloft/overlap.hpp>

#include "core/prng.hpp"
#include "unit/motion/motion_stacks.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

void expect_near(const std::optional<Point2>& got, const Point2& want, double tolerance) {
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->x, want.x, tolerance);
  EXPECT_NEAR(got->y, want.y, tolerance);
}

bool same(const SlabMotions& a, const SlabMotions& b) {
  return a.lower == b.lower && a.upper == b.upper;
}

SectionStack scaled(SectionStack stack, double by) {
  for (Section& section : stack.sections) {
    section.z *= by;
    for (Contour& contour : section.contours) {
      for (Point2& p : contour.vertices) p = {p.x * by, p.y * by};
    }
  }
  return stack;
}

TEST(RegionMotions, ATranslationOfOneContourIsFound) {
  for (const Point2& lean : {Point2{0, 0}, {0.4, -0.25}, {0.7, 0.6}, {-0.9, 0.1}, {0.11, 0.07}}) {
    const SectionStack stack = leaning_rods({{3, 5}}, 0.5, lean, {0, 1});
    const SlabMotions motions = all_motions(stack, 0);
    expect_near(motions.lower[RegionId(0)], lean, 0.1);
    expect_near(motions.upper[RegionId(0)], lean, 0.1);
  }
}

TEST(RegionMotions, UnequalGapsShareAVelocity) {
  const SectionStack stack = leaning_rods({{0, 0}, {1.7, 0.2}}, 0.4, {0.6, 0.3}, {0, 0.8, 2.2, 3});
  for (const double gap : {0.8, 1.4, 0.8}) {
    const std::size_t slab = gap == 1.4 ? 1 : 0;
    const SlabMotions motions = all_motions(stack, slab);
    for (const auto* side : {&motions.lower, &motions.upper}) {
      for (const auto& u : *side) expect_near(u, {0.6 * gap, 0.3 * gap}, 0.1 * gap);
    }
  }
}

TEST(RegionMotions, RodsThatLeanByMoreThanTheirDistanceKeepTheirOwn) {
  // Where they lie, each overlaps its neighbour in the next section more than itself.
  const std::vector<Point2> centres{{0, 0},      {0.72, 0.1}, {1.38, -0.05}, {0.3, 0.75},
                                    {1.1, 0.66}, {0.05, 1.4}, {0.83, 1.35},  {1.6, 1.28}};
  const SectionStack stack = leaning_rods(centres, 0.28, {0.75, 0.05}, {0, 1, 2, 3});
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const SectionId below(1), above(2);
  const SlabMotions motions = all_motions(stack, 1);
  std::size_t crossed = 0;
  for (const ContourId c : stack.sections[below].contours.ids()) {
    const RegionOutline here{{&stack.sections[below].contours[c]}};
    Contour moved = stack.sections[below].contours[c];
    const Point2 u = motions.lower[nestings[below].region[c]].value();
    for (Point2& p : moved.vertices) p = {p.x + u.x, p.y + u.y};
    for (const ContourId d : stack.sections[above].contours.ids()) {
      const RegionOutline there{{&stack.sections[above].contours[d]}};
      const double ratio = overlap_ratio(RegionOutline{{&moved}}, there);
      EXPECT_EQ(ratio > 0.5, c == d) << c.index() << ' ' << d.index() << ' ' << ratio;
      if (c != d && overlap_ratio(here, there) > 0.5) ++crossed;
    }
  }
  EXPECT_GE(crossed, 3U);
}

TEST(RegionMotions, OrderDirectionAndStartOfContoursDoNotMatter) {
  const SectionStack stack = drifting_polygons(3, 4);
  const SlabMotions want = all_motions(stack, 1);
  Prng prng(5);
  for (int round = 0; round < 5; ++round) {
    SectionStack other = stack;
    for (Section& section : other.sections) {
      std::vector<Contour>& contours = section.contours.raw();
      for (std::size_t k = contours.size(); k > 1; --k) {
        std::swap(contours[k - 1], contours[prng.below(k)]);
      }
      for (Contour& contour : contours) {
        std::vector<Point2>& v = contour.vertices;
        std::rotate(v.begin(), v.begin() + static_cast<long>(prng.below(v.size())), v.end());
        if (prng.below(2) == 0) std::reverse(v.begin(), v.end());
      }
    }
    EXPECT_TRUE(same(all_motions(other, 1), want));
  }
}

TEST(RegionMotions, DoNotDependOnWhatElseIsWanted) {
  const SectionStack stack = drifting_polygons(4, 4);
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const SlabMotions all = all_motions(stack, 1);
  for (const RegionId r : all.lower.ids()) {
    const SlabMotions one = estimate_motions(SlabId(1), stack, nestings, {{r}, {}});
    for (const RegionId s : all.lower.ids()) {
      EXPECT_EQ(one.lower[s], s == r ? all.lower[r] : std::nullopt);
    }
    for (const auto& u : one.upper) EXPECT_FALSE(u);
    const SlabMotions other = estimate_motions(SlabId(1), stack, nestings, {{}, {r}});
    EXPECT_EQ(other.upper[r], all.upper[r]);
  }
}

TEST(RegionMotions, ScaleWithTheStack) {
  const SectionStack stack = drifting_polygons(5, 4);
  const SlabMotions want = all_motions(stack, 1);
  for (const double by : {0x1p-300, 0.25, 2.0, 0x1p500}) {
    const SlabMotions got = all_motions(scaled(stack, by), 1);
    for (const RegionId r : want.lower.ids()) {
      EXPECT_EQ(got.lower[r]->x, want.lower[r]->x * by);
      EXPECT_EQ(got.upper[r]->y, want.upper[r]->y * by);
    }
  }
}

TEST(RegionMotions, AStackTurnedUpsideDownMovesTheOtherWay) {
  const SectionStack stack = drifting_polygons(6, 4);
  SectionStack turned;
  for (std::size_t s = 4; s-- > 0;) {
    turned.sections.push_back(stack.sections[SectionId(s)]);
    turned.sections[SectionId(3 - s)].z *= -1;
  }
  const SlabMotions up = all_motions(stack, 1);
  const SlabMotions down = all_motions(turned, 1);
  for (const RegionId r : up.lower.ids()) {
    EXPECT_EQ(down.upper[r]->x, -up.lower[r]->x);
    EXPECT_EQ(down.upper[r]->y, -up.lower[r]->y);
    EXPECT_EQ(down.lower[r]->x, -up.upper[r]->x);
    EXPECT_EQ(down.lower[r]->y, -up.upper[r]->y);
  }
}

TEST(RegionMotions, LieOnALatticeOfAThousandthOfAGap) {
  const SectionStack stack = drifting_polygons(8, 4);
  for (std::size_t slab = 0; slab < 3; ++slab) {
    const double gap = stack.sections[SectionId(slab + 1)].z - stack.sections[SectionId(slab)].z;
    const double unit = std::ldexp(1.0, std::ilogb(gap) - 10);
    for (const auto& u : all_motions(stack, slab).lower) {
      EXPECT_EQ(std::fmod(u->x, unit), 0);
      EXPECT_EQ(std::fmod(u->y, unit), 0);
    }
  }
}

TEST(RegionMotions, RegionsLargeAgainstTheGapStay) {
  const SectionStack stack = leaning_rods({{0, 0}}, 6.5, {0.5, 0}, {0, 1});
  EXPECT_EQ(all_motions(stack, 0).lower[RegionId(0)], Point2{});
  const SectionStack smaller = leaning_rods({{0, 0}}, 5.5, {0.5, 0}, {0, 1});
  expect_near(all_motions(smaller, 0).lower[RegionId(0)], {0.5, 0}, 0.1);
}

TEST(RegionMotions, StayWhereDoublesDoNotMeasure) {
  // A gap of nothing beside the coordinates, and one that has no quarter.
  const SectionStack far = leaning_rods({{0x1p900, 0}}, 0x1p899, {0, 0}, {0, 0x1p-900});
  EXPECT_EQ(all_motions(far, 0).lower[RegionId(0)], Point2{});
  const SectionStack thin = leaning_rods({{0, 0}}, 0x1p-1040, {0, 0}, {0, 0x1p-1073});
  EXPECT_EQ(all_motions(thin, 0).upper[RegionId(0)], Point2{});
  SectionStack beside = leaning_rods({{0, 0}}, 0.5, {0.5, 0}, {0, 1, 2});
  beside.sections[SectionId(2)].contours.push_back(octagon({0x1p50, 0}, 0x1p40));
  EXPECT_EQ(all_motions(beside, 0).lower[RegionId(0)], Point2{});
}

TEST(RegionMotions, AnEmptySectionOnEitherSideIsNoObstacle) {
  SectionStack stack = leaning_rods({{0, 0}}, 0.5, {0.5, 0}, {0, 1, 2, 3});
  stack.sections[SectionId(0)].contours.clear();
  stack.sections[SectionId(3)].contours.clear();
  const SlabMotions motions = all_motions(stack, 1);
  EXPECT_TRUE(motions.lower[RegionId(0)]);
  EXPECT_TRUE(motions.upper[RegionId(0)]);
}

TEST(RegionMotions, AreTheSameNumbersOnEveryMachine) {
  const SlabMotions motions = all_motions(
      leaning_rods({{0, 0}, {1.1, 0.3}, {0.4, 1.25}}, 0.375, {0.6, 0.25}, {0, 1, 2, 3}), 1);
  const std::vector<std::optional<Point2>> want{
      Point2{0x1.29p-1, 0x1.dep-3}, Point2{0x1.2a8p-1, 0x1.f6p-3}, Point2{0x1.2cp-1, 0x1.e6p-3}};
  EXPECT_EQ(motions.lower.raw(), want);
}

}  // namespace
}  // namespace tetloft::testing
