// Distances against all pairs of a vertex and an edge in rationals.
#include "sections/distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "sections/segments.hpp"
#include "spatial/box_tree.hpp"
#include "support/rational_geometry.hpp"
#include "support/stacks/generate.hpp"
#include "unit/sections/shapes.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using oracle::Point2Q;
using oracle::Polygon;
using oracle::Rational;
using Region = std::vector<Contour>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

double distance(const Region& a, const Region& b) {
  return region_distance(outline_of(a), outline_of(b));
}

std::optional<double> within(const Region& a, const Region& b, double limit) {
  return region_distance_within(outline_of(a), outline_of(b), limit);
}

std::vector<Polygon> polygons(const Region& region) {
  std::vector<Polygon> result(region.size());
  for (std::size_t k = 0; k < region.size(); ++k) {
    for (const Point2& p : region[k].vertices) result[k].push_back(oracle::exactly(p));
  }
  return result;
}

Rational squared_distance(const Point2Q& p, const Point2Q& a, const Point2Q& b) {
  const Rational dx = b.x - a.x;
  const Rational dy = b.y - a.y;
  Rational t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  t = std::clamp(t, Rational(0), Rational(1));
  const Rational x = a.x + t * dx - p.x;
  const Rational y = a.y + t * dy - p.y;
  return x * x + y * y;
}

bool holds(const std::vector<Polygon>& region, const Point2Q& p) {
  return std::count_if(region.begin(), region.end(),
                       [&](const Polygon& c) { return oracle::is_inside(p, c); }) %
             2 ==
         1;
}

// Of two closed regions, by definition.
Rational exact_squared_distance(const Region& region_a, const Region& region_b) {
  const std::vector<Polygon> a = polygons(region_a);
  const std::vector<Polygon> b = polygons(region_b);
  std::optional<Rational> least;
  for (const Polygon& c : a) {
    for (const Polygon& d : b) {
      for (std::size_t i = 0; i < c.size(); ++i) {
        for (std::size_t j = 0; j < d.size(); ++j) {
          const Point2Q &p = c[i], &q = c[(i + 1) % c.size()];
          const Point2Q &r = d[j], &s = d[(j + 1) % d.size()];
          if (oracle::segments_meet(p, q, r, s)) return 0;
          const Rational pair = std::min(squared_distance(p, r, s), squared_distance(r, p, q));
          least = least ? std::min(*least, pair) : pair;
        }
      }
    }
  }
  for (const Polygon& c : a) {
    if (holds(b, c[0])) return 0;
  }
  for (const Polygon& d : b) {
    if (holds(a, d[0])) return 0;
  }
  return *least;
}

// Is `got` the root of `square`, rounded to 32 bits, halves up?
void expect_rounded_root(double got, const Rational& square) {
  ASSERT_EQ(got == 0, square.sign() == 0) << got << ' ' << square.to_string();
  if (got == 0) return;
  int exponent = 0;
  const double mantissa = std::frexp(got, &exponent);
  ASSERT_EQ(std::ldexp(mantissa, 32), std::floor(std::ldexp(mantissa, 32))) << got;
  // Numbers of 32 bits are twice as dense below a power of two.
  const Rational unit = Rational::exactly(std::ldexp(1, exponent - 32));
  const Rational low = Rational::exactly(got) - unit / Rational(mantissa == 0.5 ? 4 : 2);
  const Rational high = Rational::exactly(got) + unit / Rational(2);
  ASSERT_LE(low * low, square) << got;
  ASSERT_LT(square, high * high) << got;
}

// All that the contract says about one pair.
void expect_exact(const Region& a, const Region& b) {
  const double got = distance(a, b);
  ASSERT_NO_FATAL_FAILURE(expect_rounded_root(got, exact_squared_distance(a, b)));
  ASSERT_EQ(distance(b, a), got);
  ASSERT_EQ(within(a, b, got), got);
  ASSERT_EQ(within(b, a, std::nextafter(got, kInfinity)), got);
  ASSERT_EQ(within(a, b, std::nextafter(got, -1.0)), std::nullopt);
  ASSERT_EQ(within(a, b, got / 2), got == 0 ? std::optional(0.0) : std::nullopt);
}

Region moved(const Region& region, double factor, Point2 offset) {
  Region result;
  for (const Contour& c : region) result.push_back(testing::moved(c, factor, offset));
  return result;
}

Region polygon(std::size_t n, double radius, Point2 centre) {
  Region result(1);
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * 3.141592653589793 * static_cast<double>(k) / static_cast<double>(n);
    result[0].vertices.push_back(
        {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return result;
}

TEST(RegionDistance, OfSimpleShapes) {
  const Region square{rectangle(0, 0, 4, 4)};
  EXPECT_EQ(distance(square, {rectangle(6, 0, 8, 4)}), 2);
  EXPECT_EQ(distance(square, {rectangle(7, 8, 9, 9)}), 5);                 // corners
  EXPECT_EQ(distance(square, {contour({{7, 2}, {9, -90}, {9, 90}})}), 3);  // a vertex
  EXPECT_EQ(distance(square, {contour({{4, 9}, {9, 4}, {9, 9}})}),         // an edge
            std::ldexp(std::floor(std::ldexp(5 / std::sqrt(2.0), 30) + 0.5), -30));
  EXPECT_EQ(distance({rectangle(0, 0, 1, 1)}, {rectangle(0, 1.1, 1, 2)}), 3435973837 * 0x1p-35);
}

TEST(RegionDistance, IsZeroWhereRegionsShareAPoint) {
  const Region square{rectangle(0, 0, 4, 4)};
  const Region others[] = {square,
                           {rectangle(4, 0, 8, 4)},                           // an edge
                           {rectangle(4, 4, 8, 8)},                           // a corner
                           {rectangle(4, 1, 8, 3)},                           // part of an edge
                           {contour({{4, 2}, {8, 0}, {8, 4}})},               // a vertex on an edge
                           {contour({{5, 3}, {5, 5}, {3, 5}})},               // a corner on an edge
                           {rectangle(-1, 1, 5, 2)},                          // crosses
                           {rectangle(1, 1, 2, 2)},                           // is inside
                           {rectangle(-1, -1, 5, 5)},                         // is around
                           {rectangle(-5, -5, 9, 9), rectangle(0, 0, 4, 4)},  // fills its hole
                           {rectangle(-5, -5, 9, 9), rectangle(1, 1, 2, 2)},  // covers its hole
                           {rectangle(-5, -5, 9, 9), rectangle(-1, -1, 4, 5)},  // stands in it
                           {rectangle(-5, -5, 9, 9), reversed(rectangle(-1, -1, 3, 5))}};
  for (std::size_t k = 0; k < std::size(others); ++k) {
    ASSERT_NO_FATAL_FAILURE(expect_exact(square, others[k])) << k;
    EXPECT_EQ(distance(square, others[k]), 0) << k;
    EXPECT_EQ(within(square, others[k], 0), 0.0) << k;
    // Off lattices rounding may part them.
    ASSERT_NO_FATAL_FAILURE(
        expect_exact(moved(square, 0.1, {0.3, 0.7}), moved(others[k], 0.1, {0.3, 0.7})))
        << k;
  }
}

TEST(RegionDistance, InAHoleIsThatOfItsContour) {
  const Region frame{rectangle(-5, -5, 9, 9), rectangle(-2, -1, 7, 6)};
  EXPECT_EQ(distance(frame, {rectangle(0, 0, 4, 4)}), 1);
  EXPECT_EQ(distance({rectangle(0, 0, 4, 4)}, frame), 1);
  EXPECT_EQ(distance(frame, {rectangle(0, 2, 7, 3)}), 0);
  EXPECT_EQ(distance(frame, {rectangle(-1, 1, 6, 3), rectangle(0, 1.5, 1, 2)}), 1);
  // A ring in the hole of a ring, and a ring that crosses none of its contours but covers a hole.
  EXPECT_EQ(distance(frame, {rectangle(-4, -4, 8, 8), rectangle(-3, -3, 0, -2)}), 0);
}

TEST(RegionDistance, SeesTheSmallestGap) {
  const Region square{rectangle(0, 0, 4, 4)};
  const double beside = std::nextafter(4.0, 5.0);
  EXPECT_EQ(distance(square, {rectangle(beside, 0, 8, 4)}), 0x1p-50);
  EXPECT_EQ(distance(square, {rectangle(beside, beside, 8, 8)}),
            std::ldexp(std::floor(std::ldexp(std::sqrt(2.0), 31) + 0.5), -81));
  EXPECT_EQ(distance({rectangle(-1, -1, 0, 0)}, {rectangle(kLeast, -1, 1, 0)}), kLeast);
  EXPECT_EQ(distance({rectangle(-1, -1, 0, 0)}, {rectangle(kLeast, kLeast, 1, 1)}), kLeast);
  EXPECT_EQ(within({rectangle(-1, -1, 0, 0)}, {rectangle(kLeast, kLeast, 1, 1)}, kLeast), kLeast);
  EXPECT_EQ(within({rectangle(-1, -1, 0, 0)}, {rectangle(kLeast, kLeast, 1, 1)}, 0), std::nullopt);
  // A vertex off a diagonal by less than doubles show: 2^-53 / √2 in the units of 4.
  const Region corner{contour({{0, 0}, {4, 4}, {0, 8}})};
  const Region tip{contour({{std::nextafter(2.0, 3.0), 2}, {8, -4}, {8, 0}})};
  ASSERT_NO_FATAL_FAILURE(expect_exact(corner, tip));
  EXPECT_GT(distance(corner, tip), 0);
  // Far less than a denormal from a long edge, and not zero.
  const Region slope{contour({{0, 0}, {0x1p900, 0x1p-1000}, {0, 0x1p900}})};
  EXPECT_EQ(distance(slope, {rectangle(1, -1, 2, 0)}), kLeast);
  EXPECT_EQ(distance(slope, {rectangle(-1, -1, 2, 0)}), 0);
}

TEST(RegionDistance, OfExtremeCoordinates) {
  const Region far{rectangle(1e300, 0, 2e300, 1e300)};
  const Region tiny{rectangle(1e-300, 1e-300, 2e-300, 2e-300)};
  ASSERT_NO_FATAL_FAILURE(expect_exact(far, tiny));
  ASSERT_NO_FATAL_FAILURE(expect_exact(tiny, moved(tiny, 1, {3e-300, 5e-300})));
  ASSERT_NO_FATAL_FAILURE(expect_exact(far, moved(far, 1, {-2.5e300, 1.1e300})));
  ASSERT_NO_FATAL_FAILURE(expect_exact(tiny, {rectangle(-1e300, -1e300, 0, 1)}));
  const Region needle{contour({{-1e300, 1e-300}, {1e300, 3e-300}, {1e300, 1}})};
  ASSERT_NO_FATAL_FAILURE(expect_exact(needle, {rectangle(-1e-300, -1e-300, 0, 0)}));
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(distance({rectangle(-most, 0, -most / 2, 1)}, {rectangle(most / 2, 0, most, 1)}),
            kInfinity);  // rounded beyond all doubles
  EXPECT_EQ(distance({rectangle(-most, 0, most, 1)}, {rectangle(-most, 3, most, 4)}), 2);
}

TEST(RegionDistance, TakesAnyLimit) {
  const Region square{rectangle(0, 0, 4, 4)};
  const Region other{rectangle(6, 0, 8, 4)};
  EXPECT_EQ(within(square, other, kInfinity), 2.0);
  EXPECT_EQ(within(square, other, std::numeric_limits<double>::max()), 2.0);
  EXPECT_EQ(within(square, other, 2), 2.0);
  EXPECT_EQ(within(square, other, std::nextafter(2.0, 0.0)), std::nullopt);
  EXPECT_EQ(within(square, square, -1), std::nullopt);
  EXPECT_EQ(within(square, square, std::nan("")), std::nullopt);
  // Where boxes are near and regions are not.
  const Region below{contour({{0, 0}, {8, 0}, {8, 8}})};
  const Region above{contour({{0, 3}, {5, 8}, {0, 8}})};
  ASSERT_NO_FATAL_FAILURE(expect_exact(below, above));
  EXPECT_EQ(within(below, above, 2), std::nullopt);
  EXPECT_EQ(distance(square, {Contour{}}), kInfinity);
  EXPECT_EQ(within(square, {Contour{}}, 1e300), std::nullopt);
}

// At halves of the last bit, which bounds never decide, just below and just above.
TEST(RegionDistance, RoundsHalvesUp) {
  const double one = 0x1p-31;
  const Region square{rectangle(-1, -1, 0, 0)};
  for (const double gap : {1 + one / 2, 1 + 3 * one / 2, 2 - one / 2}) {
    const Region beside{rectangle(gap, -1, 9, 0)};
    ASSERT_NO_FATAL_FAILURE(expect_exact(square, beside));
    EXPECT_EQ(distance(square, beside), gap + one / 2);
    const Region nearer{rectangle(std::nextafter(gap, 0.0), -1, 9, 0)};
    ASSERT_NO_FATAL_FAILURE(expect_exact(square, nearer));
    EXPECT_EQ(distance(square, nearer), gap - one / 2);
  }
}

// A vertex from an edge along (4, −3): the distance is 5 m, and an odd number of 33 bits, in units
// that are small or large.
TEST(RegionDistance, RoundsHalvesUpBesideAnEdge) {
  Prng prng(9);
  const Region corner{rectangle(-1, -1, 0, 0)};
  for (int round = 0; round < 300; ++round) {
    const double m = static_cast<double>(0x33333335 + 2 * prng.below(0x19999998));
    const double s = static_cast<double>(1 + prng.below(0xFFFFFFFF));
    const double t = static_cast<double>(1 + prng.below(0xFFFF));
    const double unit = std::ldexp(1, static_cast<int>(prng.below(400)) - 200);
    const Region beside = moved(
        {contour(
            {{3 * m + 4 * s, 4 * m - 3 * s}, {0x1p40, 0x1p40}, {3 * m - 4 * t, 4 * m + 3 * t}})},
        unit, {0, 0});
    const Region origin = moved(corner, unit, {0, 0});
    ASSERT_NO_FATAL_FAILURE(expect_exact(origin, beside)) << "round " << round;
    ASSERT_EQ(distance(origin, beside), (5 * m + 1) * unit) << "round " << round;
    // Less than a double below the half: a corner an ulp nearer along x.
    const Region nearer{rectangle(std::nextafter(3 * m, 0.0), 4 * m, 0x1p40, 0x1p40)};
    ASSERT_NO_FATAL_FAILURE(expect_exact(corner, nearer)) << "round " << round;
    ASSERT_EQ(distance(corner, nearer), 5 * m - 1) << "round " << round;
  }
}

// Many regions that touch, contain and cross each other, on a grid of few points.
TEST(RegionDistance, AgreesWithAllPairsOnTinyGrids) {
  Prng prng(3);
  int apart = 0;
  int together = 0;
  for (int round = 0; round < 2000; ++round) {
    Region regions[2];
    bool valid = true;
    for (Region& region : regions) {
      region.resize(1);
      region[0].vertices.resize(3 + prng.below(3));
      for (Point2& p : region[0].vertices) {
        p = {static_cast<double>(prng.below(8)), static_cast<double>(prng.below(8))};
      }
      valid = valid && validate(one(region)).ok();
    }
    if (!valid) continue;
    ASSERT_NO_FATAL_FAILURE(expect_exact(regions[0], regions[1])) << "round " << round;
    (distance(regions[0], regions[1]) == 0 ? together : apart) += 1;
  }
  EXPECT_GT(apart, 50);
  EXPECT_GT(together, 50);
}

// Also with holes, which the other region may be in, and off the lattice.
TEST(RegionDistance, AgreesWithAllPairsOfStars) {
  Prng prng(4);
  int nested = 0;
  for (int round = 0; round < 150; ++round) {
    Region ring{random_star(prng, 0, 0, 24, 6)};
    const Region hole{random_star(prng, 0, 0, 14, 4)};
    ring.push_back(prng.chance(0.5) ? hole[0] : reversed(hole[0]));
    if (!validate(one(ring)).ok()) ring.pop_back();
    const int x = static_cast<int>(prng.below(60)) - 30;
    const Region star{random_star(prng, prng.chance(0.5) ? 0 : x, x / 4, 5, 3)};
    const Region a = round % 2 == 0 ? ring : moved(ring, 0.1, {0.123, 4.56});
    const Region b = round % 2 == 0 ? star : moved(star, 0.0987654321, {0.123, 4.56});
    ASSERT_NO_FATAL_FAILURE(expect_exact(a, b)) << "round " << round;
    nested += ring.size() == 2 && x * x < 25 && distance(a, b) > 0 ? 1 : 0;
  }
  EXPECT_GT(nested, 3);
}

// Parallel long edges with vertices anywhere between, an ulp or a few apart.
TEST(RegionDistance, AgreesWithAllPairsOfSlivers) {
  Prng prng(5);
  for (int round = 0; round < 60; ++round) {
    const double slope = prng.between(-1, 1);
    const auto chain = [&](double shift, double away) {
      Contour c;
      for (int k = 0; k < 4; ++k) {
        const double x = 30 * k + prng.unit();
        c.vertices.push_back({x, std::nextafter(slope * x + shift, shift < 0 ? -99. : 99.)});
      }
      c.vertices.push_back({50, away});
      return Region{c};
    };
    const double gap =
        round % 3 == 0 ? 0 : std::ldexp(prng.unit(), -static_cast<int>(prng.below(50)));
    const Region a = chain(-gap, -200);
    const Region b = chain(gap, 200);
    if (!validate(one(a)).ok() || !validate(one(b)).ok()) continue;
    ASSERT_NO_FATAL_FAILURE(expect_exact(a, b)) << "round " << round;
  }
}

TEST(RegionDistance, DoesNotDependOnScaleOrderStartOrDirection) {
  Prng prng(6);
  for (int round = 0; round < 60; ++round) {
    const Region a{rectangle(-40, -40, 40, 40), random_star(prng, 0, 0, 30, 9),
                   rectangle(-39, -39, -35, -35)};
    const Region b{random_star(prng, static_cast<int>(prng.below(90)) - 10, 3, 6, 7)};
    const double expected = distance(a, b);
    for (const double factor : {0x1p-1000, 0x1p-333, 0x1p500, 0x1p950}) {
      ASSERT_EQ(distance(moved(a, factor, {0, 0}), moved(b, factor, {0, 0})), expected * factor);
    }
    ASSERT_EQ(distance(moved(a, 1, {0x1p40, 0x1p44}), moved(b, 1, {0x1p40, 0x1p44})), expected);
    ASSERT_EQ(distance(moved(a, -1, {0, 0}), moved(b, -1, {0, 0})), expected);
    Region turned = a;
    std::swap(turned[1], turned[2]);
    for (Contour& c : turned) c = rotated(reversed(c), prng.below(c.vertices.size()));
    ASSERT_EQ(distance(turned, b), expected);
    ASSERT_EQ(distance(b, turned), expected);
  }
}

TEST(RegionDistance, OfRegionsOfGeneratedSectionsIsThatOfAllPairs) {
  for (const StackKind kind : all_kinds()) {
    const SectionStack stack = generate(kind, 5).stack;
    if (stack.sections.size() < 2) continue;
    const auto lower = outlines(stack.sections[SectionId(0)], nest(stack.sections[SectionId(0)]));
    const auto upper = outlines(stack.sections[SectionId(1)], nest(stack.sections[SectionId(1)]));
    const auto region = [](const RegionOutline& outline) {
      Region result;
      for (const Contour* c : outline.contours) result.push_back(*c);
      return result;
    };
    for (std::size_t i = 0; i < std::min<std::size_t>(lower.size(), 3); ++i) {
      for (std::size_t j = 0; j < std::min<std::size_t>(upper.size(), 3); ++j) {
        const Region a = region(lower[RegionId(i)]);
        const Region b = region(upper[RegionId(j)]);
        const bool overlap = overlap_ratio(lower[RegionId(i)], upper[RegionId(j)]) > 0;
        if (overlap) {
          ASSERT_EQ(distance(a, b), 0) << name_of(kind);
        } else if (a.front().vertices.size() * b.front().vertices.size() < 1000) {
          ASSERT_NO_FATAL_FAILURE(expect_exact(a, b)) << name_of(kind);
        }
      }
    }
  }
}

// Side by side, aside and nearly in the middle of a hole of the other, and all along such a hole,
// an edge's length away. In its very middle all is as near as the nearest: then a root of all is
// near each edge.
TEST(RegionDistance, MeasuresAFewPairsForEachEdgeHoweverManyThereAre) {
  for (const std::size_t n : {1000U, 8000U, 64000U}) {
    const double edge = 600 / static_cast<double>(n);
    const auto ring = [&](double inner, Point2 centre) {
      return Region{polygon(n, 200, centre)[0], polygon(n, inner, centre)[0]};
    };
    const struct {
      const char* name;
      Region region;
      double most;
    } cases[] = {{"beside", polygon(n, 100, {150, 190}), 2},
                 {"aside", ring(120, {12, 5}), 10},
                 {"nearly", ring(120, {0.3, 0.1}), 20},
                 {"along", ring(100 + edge, {0, 0}), 10},
                 {"middle", ring(120, {0, 0}), std::sqrt(static_cast<double>(n))}};
    const sections::ContourEdges disc(outline_of(polygon(n, 100, {0, 0})));
    for (const auto& [name, region, most] : cases) {
      const sections::Apart apart =
          sections::measure(disc, sections::ContourEdges(outline_of(region)), kInfinity);
      EXPECT_GT(*apart.distance, 0);
      EXPECT_LT(static_cast<double>(apart.pairs), most * static_cast<double>(n)) << name << n;
      RecordProperty(std::string(name) + '_' + std::to_string(n),
                     static_cast<int>(10 * apart.pairs / n));
    }
  }
}

TEST(RegionDistance, MeasuresNothingOfWhatIsBeyondTheLimit) {
  const sections::ContourEdges a(outline_of(polygon(5000, 100, {0, 0})));
  const sections::ContourEdges beside(outline_of(polygon(5000, 100, {150, 190})));
  const sections::Apart near = sections::measure(a, beside, kInfinity);
  const sections::Apart far = sections::measure(a, beside, *near.distance / 2);
  EXPECT_FALSE(far.distance);
  EXPECT_LT(far.pairs, 100U);
  EXPECT_EQ(sections::measure(a, beside, *near.distance).distance, near.distance);
}

TEST(Segments, TouchAsRationalsSay) {
  Prng prng(10);
  int touching = 0;
  for (int round = 0; round < 5000; ++round) {
    Point2 p[4];
    for (Point2& q : p) {
      q = {static_cast<double>(prng.below(4)), static_cast<double>(prng.below(4))};
    }
    if (p[0] == p[1] || p[2] == p[3]) continue;
    if (!box_of(p[0], p[1]).meets(box_of(p[2], p[3]))) continue;
    const bool expected = oracle::segments_meet(oracle::exactly(p[0]), oracle::exactly(p[1]),
                                                oracle::exactly(p[2]), oracle::exactly(p[3]));
    ASSERT_EQ(sections::touch(p[0], p[1], p[2], p[3]), expected) << "round " << round;
    touching += expected ? 1 : 0;
  }
  EXPECT_GT(touching, 1000);
}

TEST(CompareArea, IsExact) {
  const auto sign = [](const Region& region, double side) {
    return static_cast<int>(compare_area(outline_of(region), side));
  };
  const Region frame{rectangle(0, 0, 10, 10), rectangle(1, 1, 9, 9)};  // 36
  for (const double factor : {1.0, 0x1p-1000, 0x1p-500, 0x1p900}) {
    for (const Region& region : {frame, Region{reversed(frame[0]), reversed(frame[1])}}) {
      const Region scaled = moved(region, factor, {0, 0});
      EXPECT_EQ(sign(scaled, 6 * factor), 0);
      EXPECT_EQ(sign(scaled, -6 * factor), 0);
      EXPECT_EQ(sign(scaled, std::nextafter(6.0, 0.0) * factor), 1);
      EXPECT_EQ(sign(scaled, std::nextafter(6.0, 7.0) * factor), -1);
      EXPECT_EQ(sign(scaled, 0), 1);
    }
    EXPECT_EQ(sign(moved(frame, factor, {0, 0}), std::numeric_limits<double>::max()), -1);
  }
  EXPECT_EQ(sign(frame, kInfinity), -1);
  EXPECT_EQ(sign(frame, std::nan("")), -1);
  EXPECT_EQ(sign({rectangle(0, 0, 1e300, 1e-300)}, kLeast), 1);
  Prng prng(8);
  for (int round = 0; round < 200; ++round) {
    const Region star = moved({random_star(prng, 5, 7, 30, 9)}, 0.1, {0.3, 0.7});
    const Rational area = exact_area(star);
    const double near = std::sqrt(area.approximate());
    for (const double side : {near, std::nextafter(near, 0.0), std::nextafter(near, 99.0), 1.0}) {
      const Rational s = Rational::exactly(side);
      ASSERT_EQ(sign(star, side), (area - s * s).sign()) << round;
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
