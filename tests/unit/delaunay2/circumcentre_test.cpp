#include <cmath>

#include <gtest/gtest.h>

#include <tetloft/delaunay.hpp>

#include "planar_sets.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::test {
namespace {

using oracle::Rational;

/// The exact circumcentre.
std::array<Rational, 2> oracle_circumcentre(const Point2& a, const Point2& b, const Point2& c) {
  const auto difference = [](double p, double q) {
    return Rational::exactly(p) - Rational::exactly(q);
  };
  const Rational bx = difference(b.x, a.x), by = difference(b.y, a.y);
  const Rational cx = difference(c.x, a.x), cy = difference(c.y, a.y);
  const Rational d = Rational(2) * (bx * cy - by * cx);
  const Rational b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  return {Rational::exactly(a.x) + (b2 * cy - c2 * by) / d,
          Rational::exactly(a.y) + (c2 * bx - b2 * cx) / d};
}

void expect_close(const Point2& a, const Point2& b, const Point2& c) {
  const auto exact = oracle_circumcentre(a, b, c);
  const Point2 got = circumcentre(a, b, c);
  const double size = std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y),
                                std::abs(c.x), std::abs(c.y), std::abs(got.x), std::abs(got.y)});
  const Rational tolerance = Rational::exactly(size) * Rational::exactly(0x1p-49);
  EXPECT_LE((Rational::exactly(got.x) - exact[0]).abs(), tolerance);
  EXPECT_LE((Rational::exactly(got.y) - exact[1]).abs(), tolerance);
}

TEST(Circumcentre, OfSimpleTriangles) {
  EXPECT_EQ(circumcentre({0, 0}, {2, 0}, {0, 2}), (Point2{1, 1}));
  EXPECT_EQ(circumcentre({3, 4}, {-5, 0}, {0, -5}), (Point2{0, 0}));
}

TEST(Circumcentre, DoesNotDependOnTheOrderOfItsArguments) {
  Prng prng(1);
  for (int k = 0; k < 100; ++k) {
    const Points p = uniform(3, prng);
    const Point2 expected = circumcentre(p[0], p[1], p[2]);
    EXPECT_EQ(circumcentre(p[1], p[2], p[0]), expected);
    EXPECT_EQ(circumcentre(p[2], p[1], p[0]), expected);
  }
}

TEST(Circumcentre, IsAccurateForRandomTriangles) {
  Prng prng(2);
  for (int k = 0; k < 300; ++k) {
    const Points p = uniform(3, prng);
    expect_close(p[0], p[1], p[2]);
  }
}

TEST(Circumcentre, IsAccurateForSlivers) {
  Prng prng(3);
  for (int k = 0; k < 300; ++k) {
    const Point2 a{prng.unit(), prng.unit()};
    const Point2 b{prng.unit(), prng.unit()};
    const double t = prng.unit();
    const Point2 c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y) + 0x1p-45 * prng.unit()};
    expect_close(a, b, c);
  }
}

TEST(Circumcentre, DoesNotOverflow) {
  expect_close({0, 0}, {0x1p1000, 0}, {0, 0x1p1000});
  expect_close({-0x1p1000, 0}, {0x1p1000, 0x1p999}, {0, 0x1p1000});
  expect_close({0, 0}, {0x1p-1060, 0}, {0, 0x1p-1060});
}

TEST(Circumcentre, OfCollinearPointsIsNotFinite) {
  const Point2 c = circumcentre({0, 0}, {1, 1}, {2, 2});
  EXPECT_FALSE(std::isfinite(c.x) && std::isfinite(c.y));
}

}  // namespace
}  // namespace tetloft::test
