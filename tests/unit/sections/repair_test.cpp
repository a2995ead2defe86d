// repair(): the region of odd crossing number, as valid contours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {
namespace {

using Contours = std::vector<Contour>;

Repaired repaired(const Contours& contours) {
  Result<Repaired> result = repair(one(contours));
  EXPECT_TRUE(result.ok()) << to_string(result.error());
  return result.ok() ? *result : Repaired{};
}

const std::vector<Contour>& contours_of(const Repaired& result) {
  return result.stack.sections[SectionId(0)].contours.raw();
}

double total_area(const Repaired& result) {
  double sum = 0;
  const Section& section = result.stack.sections[SectionId(0)];
  const Nesting nesting = nest(section);
  for (const RegionOutline& region : outlines(section, nesting)) sum += area(region);
  return sum;
}

// By crossings of a ray, for p on no edge.
bool is_odd(const Contours& contours, const Point2& p) {
  bool odd = false;
  for (const Contour& c : contours) odd = odd != is_inside(c, p);
  return odd;
}

double distance_to(const Contours& contours, const Point2& p) {
  double least = INFINITY;
  for (const Contour& c : contours) {
    for (std::size_t k = 0; k < c.vertices.size(); ++k) {
      const Point2& a = c.vertices[k];
      const Point2& b = c.vertices[(k + 1) % c.vertices.size()];
      const double dx = b.x - a.x;
      const double dy = b.y - a.y;
      const double square = dx * dx + dy * dy;
      const double t =
          square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
      least = std::min(least, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
  }
  return least;
}

TEST(Repair, LeavesValidStacksAlone) {
  for (const StackKind kind : all_kinds()) {
    if (kind == StackKind::scale_offset || kind == StackKind::large_contours) continue;
    const SectionStack stack = generate(kind, 77).stack;
    const auto result = repair(stack);
    ASSERT_TRUE(result.ok()) << name_of(kind) << to_string(result.error());
    EXPECT_TRUE(result->changes.empty()) << name_of(kind) << to_string(result->changes.front());
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const auto& before = stack.sections[SectionId(s)].contours;
      const auto& after = result->stack.sections[SectionId(s)].contours;
      ASSERT_EQ(before.size(), after.size());
      for (std::size_t c = 0; c < before.size(); ++c) {
        EXPECT_EQ(before[ContourId(c)].vertices, after[ContourId(c)].vertices);
      }
    }
  }
}

TEST(Repair, ABowtieBecomesTwoTriangles) {
  const Repaired result = repaired({contour({{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  EXPECT_EQ(contours_of(result).size(), 2U);
  EXPECT_NEAR(total_area(result), 2, 1e-4);
  EXPECT_EQ(result.changes.size(), 2U);  // the crossing and the contact there
  EXPECT_EQ(result.changes[0].where.point, (Point3{1, 1, 0}));
  EXPECT_LE(result.moved, 0x1p-19);
}

TEST(Repair, ASpikeGoes) {
  const Repaired result =
      repaired({contour({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}})});
  ASSERT_EQ(contours_of(result).size(), 1U);
  EXPECT_EQ(total_area(result), 4);
  EXPECT_EQ(result.moved, 0);
}

TEST(Repair, ContoursWithoutAreaGo) {
  const Repaired result = repaired({rectangle(0, 0, 1, 1), contour({{3, 0}, {4, 1}, {5, 2}}),
                                    contour({{7, 7}, {8, 8}}), contour({{9, 9}})});
  ASSERT_EQ(contours_of(result).size(), 1U);
  EXPECT_EQ(contours_of(result)[0].vertices, rectangle(0, 0, 1, 1).vertices);
  EXPECT_EQ(result.changes.size(), 5U);  // the collinear one cancels in two pieces of its own
}

TEST(Repair, WhatCancelsIsLostLoudly) {
  // Twice around, in one contour.
  const Contour twice = contour({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Repaired result = repaired({twice, rectangle(3, 0, 4, 1)});
  ASSERT_EQ(contours_of(result).size(), 1U);
  ASSERT_EQ(result.lost.size(), 1U);
  EXPECT_EQ(result.lost[0].contour, ContourId(0));
  EXPECT_EQ(result.lost[0].area, 2);
  EXPECT_EQ(result.area_after, 1);
  EXPECT_TRUE(std::any_of(result.changes.begin(), result.changes.end(), [](const Warning& w) {
    return w.message.find("NOTHING IS LEFT") != std::string::npos && w.where.contour == 0U &&
           w.where.section == 0U && w.message.find("area of 2") != std::string::npos;
  }));
  const auto kept = repair(one({twice}), {.fill = FillRule::winding});
  ASSERT_TRUE(kept.ok());
  EXPECT_EQ(kept->area_after, 1);
  EXPECT_TRUE(kept->lost.empty());
  // Two halves, and both again.
  const Repaired none =
      repaired({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1), rectangle(0, 0, 2, 1)});
  EXPECT_TRUE(contours_of(none).empty());
  EXPECT_EQ(none.lost.size(), 3U);
}

TEST(Repair, NeighboursThatShareASideBecomeOne) {
  const Repaired result = repaired({rectangle(0, 0, 1, 1), rectangle(1, 0, 2, 1)});
  EXPECT_EQ(contours_of(result).size(), 1U);
  EXPECT_EQ(total_area(result), 2);
}

TEST(Repair, NeighboursThatTouchAtACornerArePartedThere) {
  const Repaired result = repaired({rectangle(0, 0, 1, 1), rectangle(1, 1, 2, 2)});
  EXPECT_EQ(contours_of(result).size(), 2U);
  EXPECT_NEAR(total_area(result), 2, 1e-9);
}

TEST(Repair, AHoleThatTouchesFromInsideStaysAHole) {
  // The corner of the hole lies on the outer contour: the region pinches nowhere, its boundary
  // does.
  const Repaired result = repaired({rectangle(0, 0, 4, 4), contour({{2, 0}, {3, 2}, {1, 2}})});
  EXPECT_NEAR(total_area(result), 14, 1e-4);
  EXPECT_TRUE(validate(result.stack).ok());
}

TEST(Repair, OverlapsOfTwoContoursAreOutside) {
  const Repaired result = repaired({rectangle(0, 0, 2, 2), rectangle(1, 1, 3, 3)});
  EXPECT_NEAR(total_area(result), 6, 1e-4);
}

TEST(Repair, NamesWhatItCannotMend) {
  SectionStack stack = one({contour({{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  EXPECT_EQ(repair(stack, {.distance = -1.0}).error().code, ErrorCode::usage);
  stack.sections[SectionId(0)].contours[ContourId(0)].vertices[1].x = NAN;
  const auto bad = repair(stack);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().where.vertex, 1U);
  // At most half an ulp may move: corners cannot be cut off by so little.
  const SectionStack bowtie = one({contour({{0, 0}, {2, 2}, {2, 0}, {0, 2}})});
  const auto refused = repair(bowtie, {.distance = 1e-300});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(refused.error().where.section, 0U);
  EXPECT_EQ(refused.error().where.contour, 0U);
}

// On few lattice points everything touches; on many, it crosses.
std::uint64_t side_of(int round) { return round % 3 == 0 ? 5 : round % 3 == 1 ? 9 : 1000000; }

// Contours of random vertices on the lattice from 0 to below side.
Contours tangle(Prng& prng, std::uint64_t count, std::uint64_t side) {
  Contours contours(count);
  for (Contour& c : contours) {
    for (std::uint64_t n = 3 + prng.below(9); n > 0; --n) {
      c.vertices.push_back(
          {static_cast<double>(prng.below(side)), static_cast<double>(prng.below(side))});
    }
  }
  return contours;
}

// By edges across a ray to the left, for p on no edge.
bool is_wound_around(const Contours& contours, const Point2& p) {
  int sum = 0;
  for (const Contour& c : contours) {
    for (std::size_t k = 0; k < c.vertices.size(); ++k) {
      const Point2& a = c.vertices[k];
      const Point2& b = c.vertices[(k + 1) % c.vertices.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const bool left_of_p = orient2d(a, b, p) == (b.y > a.y ? Sign::negative : Sign::positive);
      if (left_of_p) sum += b.y > a.y ? 1 : -1;
    }
  }
  return sum != 0;
}

TEST(Repair, KeepsTheRegionOfWindingNumber) {
  Prng prng(33);
  std::size_t compared = 0;
  std::size_t refused = 0;
  for (int round = 0; round < 400; ++round) {
    const std::uint64_t side = side_of(round);
    const Contours contours = tangle(prng, 1 + prng.below(3), side);
    const auto result = repair(one(contours), {.fill = FillRule::winding});
    if (!result.ok()) {
      ++refused;
      continue;
    }
    ASSERT_TRUE(result->stack.contour_count() == 0 || validate(result->stack).ok());
    const double extent = static_cast<double>(side);
    const Contours after = contours_of(*result);
    for (int k = 0; k < 30; ++k) {
      const Point2 p{prng.between(0, extent), prng.between(0, extent)};
      if (distance_to(contours, p) <= 2 * 0x1p-20 * extent) continue;
      ASSERT_EQ(is_wound_around(contours, p), is_odd(after, p)) << "round " << round;
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_LE(refused, 3U);
}

TEST(Repair, KeepsTheRegionOfOddCrossingNumber) {
  Prng prng(31);
  std::size_t changed = 0;
  std::size_t compared = 0;
  std::size_t refused = 0;
  for (int round = 0; round < 600; ++round) {
    const std::uint64_t side = side_of(round);
    const Contours contours = tangle(prng, 1 + prng.below(3), side);
    const auto result = repair(one(contours));
    if (!result.ok()) {
      ++refused;
      ASSERT_EQ(result.error().code, ErrorCode::invalid_input);
      continue;
    }
    // Where all cancels nothing is left.
    ASSERT_TRUE(result->stack.contour_count() == 0 || validate(result->stack).ok());
    changed += result->changes.empty() ? 0U : 1U;
    const double extent = static_cast<double>(side);
    ASSERT_LE(result->moved, 0x1p-20 * extent);
    const Contours after = contours_of(*result);
    for (int k = 0; k < 30; ++k) {
      const Point2 p{prng.between(0, extent), prng.between(0, extent)};
      // Twice: a corner cut off at both of its ends.
      if (distance_to(contours, p) <= 2 * 0x1p-20 * extent) continue;
      ASSERT_EQ(is_odd(contours, p), is_odd(after, p)) << "round " << round;
      ++compared;
    }
  }
  EXPECT_GT(changed, 520U);
  EXPECT_GT(compared, 16000U);
  EXPECT_LE(refused, 3U);  // allowed, but not often
}

// Whatever begins where and goes which way round.
std::vector<std::vector<std::pair<double, double>>> normalised(const Contours& contours) {
  std::vector<std::vector<std::pair<double, double>>> result;
  for (const Contour& c : contours) {
    std::vector<std::pair<double, double>> v;
    for (const Point2& p : c.vertices) v.emplace_back(p.x, p.y);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    if (v.back() < v[1]) std::reverse(v.begin() + 1, v.end());
    result.push_back(v);
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Repair, DependsOnNeitherOrderNorStartNorDirectionOfContours) {
  Prng prng(32);
  std::size_t compared = 0;
  for (int round = 0; round < 300; ++round) {
    Contours contours = tangle(prng, 2 + prng.below(3), side_of(round));
    if (round % 5 == 0) contours.push_back(contours.front());
    const RepairOptions options{.fill = static_cast<FillRule>(round % 2)};
    const auto result = repair(one(contours), options);
    Contours other = contours;
    prng.shuffle(other);
    for (Contour& c : other) {
      std::rotate(c.vertices.begin(),
                  c.vertices.begin() + static_cast<std::ptrdiff_t>(prng.below(c.vertices.size())),
                  c.vertices.end());
      if (prng.chance(0.5)) std::reverse(c.vertices.begin(), c.vertices.end());
    }
    const auto again = repair(one(other), options);
    ASSERT_EQ(result.ok(), again.ok()) << "round " << round;
    if (!result.ok()) continue;
    ASSERT_EQ(normalised(contours_of(*result)), normalised(contours_of(*again)))
        << "round " << round;
    ++compared;
  }
  EXPECT_GT(compared, 290U);
}

}  // namespace
}  // namespace tetloft::testing
