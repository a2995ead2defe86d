// Overlaps against exact clipping, and at equality.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "sections/interiors.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using oracle::Rational;
using Region = std::vector<Contour>;

double ratio(const Region& a, const Region& b) {
  return overlap_ratio(outline_of(a), outline_of(b));
}
int sign(const Region& a, const Region& b, double tau) {
  return static_cast<int>(compare_overlap(outline_of(a), outline_of(b), tau));
}

Rational exact_ratio(const Region& a, const Region& b) {
  const Rational area_a = exact_area(a);
  const Rational area_b = exact_area(b);
  return overlap_by_clipping(a, b) / (area_a < area_b ? area_a : area_b);
}

// All that the contract says about one pair.
void expect_exact(const Region& a, const Region& b) {
  const Rational exact = exact_ratio(a, b);
  const double got = ratio(a, b);
  ASSERT_EQ(got == 0, exact.sign() == 0) << exact.to_string();
  ASSERT_LE((Rational::exactly(got) - exact).abs(), exact * Rational::exactly(0x1p-32));
  ASSERT_EQ(ratio(b, a), got);
  const double near = exact.approximate();
  for (const double tau : {0.0, 0.02, 0.25, 0.5, 1.0, near, std::nextafter(near, 0.0),
                           std::nextafter(near, 2.0), got}) {
    const int expected = (exact - Rational::exactly(tau)).sign();
    ASSERT_EQ(sign(a, b, tau), expected) << exact.to_string() << ' ' << tau;
    ASSERT_EQ(sign(b, a, tau), expected);
  }
}

Region moved(const Region& region, double factor, Point2 offset) {
  Region result;
  for (const Contour& c : region) result.push_back(testing::moved(c, factor, offset));
  return result;
}

// A star with up to two holes, on the lattice.
Region random_region(Prng& prng, int x, int y, int radius) {
  Region region{random_star(prng, x, y, radius, 10)};
  const double s = radius / 4;
  for (const double corner : {-1.0, 1.0}) {
    if (prng.chance(0.5)) continue;
    Contour hole = rectangle(x + (corner < 0 ? -s : 1), y - s, x + (corner < 0 ? -1 : s), y + s);
    Region with = region;
    with.push_back(prng.chance(0.5) ? hole : reversed(hole));
    Section section = testing::section(0, with);
    if (validate(stack({section})).ok() && nest(section).outer.size() == 1) region = with;
  }
  if (prng.chance(0.5)) region[0] = reversed(region[0]);
  return region;
}

// The same about a point up to `reach` away from the origin along each axis.
Region region_near(Prng& prng, int reach, int radius) {
  const auto range = static_cast<std::uint64_t>(2 * reach);
  const int x = static_cast<int>(prng.below(range)) - reach;
  const int y = static_cast<int>(prng.below(range)) - reach;
  return random_region(prng, x, y, radius);
}

TEST(OverlapRatio, OfSimpleSquares) {
  const Region square{rectangle(0, 0, 4, 4)};
  EXPECT_EQ(ratio(square, square), 1);
  EXPECT_EQ(ratio(square, {rectangle(2, 0, 6, 4)}), 0.5);
  EXPECT_EQ(ratio(square, {rectangle(1, 1, 2, 2)}), 1);
  EXPECT_EQ(ratio(square, {rectangle(3, 3, 7, 7)}), 1.0 / 16);
  EXPECT_EQ(ratio(square, {rectangle(5, 0, 9, 4)}), 0);
}

TEST(OverlapRatio, IsZeroWhereRegionsOnlyTouch) {
  const Region square{rectangle(0, 0, 4, 4)};
  const Region others[] = {{rectangle(4, 0, 8, 4)},                        // an edge
                           {rectangle(4, 4, 8, 8)},                        // a corner
                           {rectangle(4, 1, 8, 3)},                        // part of an edge
                           {contour({{4, 2}, {8, 0}, {8, 4}})},            // a vertex on an edge
                           {contour({{4, 5}, {4, 4}, {5, 4}, {8, 8}})},    // a corner, at an angle
                           {contour({{5, -1}, {3, 5}, {6, 6}, {6, -2}})},  // cuts the corner off
                           {rectangle(-5, -5, 9, 9), rectangle(0, 0, 4, 4)},    // fills its hole
                           {rectangle(-5, -5, 9, 9), rectangle(-1, 0, 4, 5)}};  // stands in it
  for (std::size_t k = 0; k < std::size(others); ++k) {
    const bool touches = k != 5;
    EXPECT_EQ(ratio(square, others[k]) == 0, touches) << k;
    EXPECT_EQ(sign(square, others[k], 0), touches ? 0 : 1) << k;
    EXPECT_EQ(ratio(others[k], square) == 0, touches) << k;
    // The same where the lattice is not that of small integers.
    const Region a = moved(square, 0.1, {0.3, 0.7});
    Region b = moved(others[k], 0.1, {0.3, 0.7});
    EXPECT_EQ(ratio(a, b) == 0, exact_ratio(a, b).sign() == 0) << k;
  }
}

TEST(OverlapRatio, SeesTheSmallestOverlap) {
  const double inside = std::nextafter(4.0, 0.0);
  const Region square{rectangle(0, 0, 4, 4)};
  EXPECT_GT(ratio(square, {rectangle(inside, 1, 8, 3)}), 0);
  EXPECT_EQ(sign(square, {rectangle(inside, 1, 8, 3)}, 0), 1);
  EXPECT_EQ(sign(square, {rectangle(inside, inside, 8, 8)}, 0), 1);
  const Region tiny{rectangle(inside, inside, 0x1p900, 0x1p900)};
  EXPECT_EQ(ratio(square, tiny), 0x1p-106);
  EXPECT_EQ(sign({rectangle(0, 0, 0x1p900, 0x1p900)},
                 {rectangle(-0x1p900, -0x1p900, 0x1p-1000, 0x1p-1000)}, 0),
            1);
}

TEST(CompareOverlap, KnowsEquality) {
  const Region square{rectangle(0, 0, 4, 4)};
  EXPECT_EQ(sign(square, {rectangle(2, 0, 6, 4)}, 0.5), 0);
  EXPECT_EQ(sign(square, {rectangle(3, 3, 7, 7)}, 0.0625), 0);
  EXPECT_EQ(sign(square, square, 1), 0);
  // One fiftieth is no double: the double 0.02 is a little more.
  const Region fiftieth{rectangle(0, 0, 50, 1)};
  EXPECT_EQ(sign(fiftieth, {rectangle(49, 0, 99, 1)}, 0.02), -1);
  EXPECT_EQ(sign(fiftieth, {rectangle(49, 0, 99, 1)}, std::nextafter(0.02, 0)), 1);
  // Diagonals: a triangle of half the square.
  EXPECT_EQ(sign(square, {contour({{0, 0}, {8, 0}, {0, 8}, {-8, 8}, {-8, 0}})}, 0.875), 1);
  EXPECT_EQ(sign({contour({{0, 0}, {4, 0}, {0, 4}})}, {contour({{4, 4}, {0, 4}, {4, 0}})}, 0), 0);
  EXPECT_EQ(sign({contour({{0, 0}, {4, 0}, {0, 4}})}, {contour({{4, 4}, {0, 3}, {3, 0}})}, 0), 1);
}

TEST(CompareOverlap, TakesAnyTau) {
  const Region square{rectangle(0, 0, 4, 4)};
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sign(square, square, inf), -1);
  EXPECT_EQ(sign(square, square, 1.5), -1);
  EXPECT_EQ(sign(square, square, -inf), 1);
  EXPECT_EQ(sign(square, {rectangle(9, 9, 10, 10)}, -0.5), 1);
  EXPECT_EQ(sign(square, {rectangle(9, 9, 10, 10)}, 0), 0);
  EXPECT_EQ(sign(square, {rectangle(9, 9, 10, 10)}, 0x1p-1074), -1);
}

TEST(Overlap, AgreesWithClippingOnLattices) {
  Prng prng(1);
  int empty = 0;
  for (int round = 0; round < 30; ++round) {
    const Region a = random_region(prng, 0, 0, 8);
    const Region b = region_near(prng, 12, 6);
    expect_exact(a, b);
    if (HasFatalFailure()) FAIL() << "round " << round;
    empty += ratio(a, b) == 0 ? 1 : 0;
  }
  EXPECT_GT(empty, 2);
}

// Just within and just beyond the lattices of 128-bit arithmetic.
TEST(Overlap, AgreesWithClippingOnLargeLattices) {
  Prng prng(9);
  for (const int radius : {1 << 17, (1 << 18) + 12345, 1 << 19, 1 << 24}) {
    const Region a{random_star(prng, 0, 0, radius, 8)};
    const Region b{random_star(prng, radius / 3, radius / 5, radius / 2, 6)};
    expect_exact(a, b);
    if (HasFatalFailure()) FAIL() << "radius " << radius;
  }
}

TEST(Overlap, AgreesWithClippingOffLattices) {
  Prng prng(2);
  for (int round = 0; round < 3; ++round) {
    const Region a = moved(random_region(prng, 0, 0, 8), 0.1, {0.123, 4.56});
    const Region b = moved(region_near(prng, 10, 6), 0.0987654321, {0.123, 4.56});
    expect_exact(a, b);
    if (HasFatalFailure()) FAIL() << "round " << round;
  }
}

// Many regions that touch, contain and cross each other, on a grid of few points.
TEST(Overlap, AgreesWithClippingOnTinyGrids) {
  Prng prng(3);
  int touching = 0;
  for (int round = 0; round < 6000; ++round) {
    Region regions[2];
    bool valid = true;
    for (Region& region : regions) {
      region.resize(1);
      region[0].vertices.resize(3 + prng.below(3));
      for (Point2& p : region[0].vertices) {
        p = {static_cast<double>(prng.below(6)), static_cast<double>(prng.below(6))};
      }
      valid = valid && validate(one(region)).ok();
    }
    if (!valid) continue;
    const Rational exact = overlap_by_clipping(regions[0], regions[1]);
    ASSERT_EQ(ratio(regions[0], regions[1]) == 0, exact.sign() == 0) << "round " << round;
    ASSERT_EQ(sign(regions[0], regions[1], 0), exact.sign()) << "round " << round;
    // Intervals decide most of these before topology is asked.
    ASSERT_EQ(sections::interiors_meet(outline_of(regions[0]), outline_of(regions[1])),
              exact.sign() != 0);
    touching += exact.sign() == 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 100);
}

TEST(Overlap, DoesNotDependOnScaleStartOrDirection) {
  Prng prng(4);
  for (int round = 0; round < 60; ++round) {
    const Region a = random_region(prng, 0, 0, 8);
    const Region b = random_region(prng, static_cast<int>(prng.below(16)) - 8, 3, 6);
    const double expected = ratio(a, b);
    for (const double factor : {0x1p-1000, 0x1p-333, 0x1p500, 0x1p950}) {
      ASSERT_EQ(ratio(moved(a, factor, {0, 0}), moved(b, factor, {0, 0})), expected) << factor;
    }
    ASSERT_EQ(ratio(moved(a, 1, {0x1p40, 0x1p44}), moved(b, 1, {0x1p40, 0x1p44})), expected);
    ASSERT_EQ(ratio(moved(a, -1, {0, 0}), moved(b, -1, {0, 0})), expected);
    Region turned = a;
    for (Contour& c : turned) c = rotated(reversed(c), prng.below(c.vertices.size()));
    ASSERT_EQ(ratio(turned, b), expected);
  }
}

TEST(Overlap, OfRegionsOfGeneratedSectionsIsConsistent) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 5).stack;
    if (stack.sections.size() < 2) continue;
    const Section& below = stack.sections[SectionId(0)];
    const Section& above = stack.sections[SectionId(1)];
    const Nesting lower = nest(below);
    const Nesting upper = nest(above);
    for (std::size_t i = 0; i < std::min<std::size_t>(lower.outer.size(), 4); ++i) {
      for (std::size_t j = 0; j < std::min<std::size_t>(upper.outer.size(), 4); ++j) {
        const RegionOutline a = outline(below, lower, RegionId(i));
        const RegionOutline b = outline(above, upper, RegionId(j));
        const double r = overlap_ratio(a, b);
        ASSERT_EQ(compare_overlap(a, b, 0) == Sign::positive, r > 0) << name_of(kind);
        ASSERT_GE(r, 0);
        ASSERT_LE(r, 1);
        if (r == 0) continue;
        ASSERT_EQ(compare_overlap(a, b, r * (1 - 0x1p-30)), Sign::positive) << name_of(kind);
        if (r < 1) {
          ASSERT_EQ(compare_overlap(a, b, r * (1 + 0x1p-30)), Sign::negative);
        }
      }
    }
  }
}

// Far above what is measured (0.05 s), so that only a quadratic step shows.
TEST(Overlap, OfLargeContoursIsFast) {
  Prng prng(6);
  Region a{Contour{}};
  for (int k = 0; k < 20000; ++k) {
    const double angle = k * 3.14159265358979 / 10000;
    const double radius = 100 + prng.unit();
    a[0].vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const Region b = moved(a, 1, {12.3, 45.6});
  const auto start = std::chrono::steady_clock::now();
  const double r = ratio(a, b);
  EXPECT_NEAR(r, 0.702, 0.01);
  EXPECT_EQ(sign(a, b, 0.02), 1);
  EXPECT_EQ(sign(a, moved(a, 1, {160, 160}), 0.02), -1);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_LT(taken.count(), 10);
}

// So folded that intervals are wide: no exact sum of millions of terms is begun.
TEST(OverlapRatio, OfFoldedContoursIsBounded) {
  Prng prng(7);
  const Region a{random_star(prng, 0, 0, 1000000, 2000)};
  const Region b{random_star(prng, 1000, 500, 1000000, 2000)};
  const double r = ratio(a, b);
  EXPECT_GT(r, 0.5);
  EXPECT_LT(r, 0.9);
  EXPECT_EQ(sign(a, b, r - 1e-6), 1);
  EXPECT_EQ(sign(a, b, r + 1e-6), -1);
}

}  // namespace
}  // namespace tetloft::testing
