#include "check/edge_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/prng.hpp"
#include "support/exact/rational.hpp"

namespace tetloft {

using namespace internal;
namespace {

using checking::advances;
using checking::distance_from_edge;
using checking::edge_ulp;
using oracle::Rational;

TEST(EdgeUlp, IsTheSpacingAtTheLargestCoordinate) {
  EXPECT_EQ(edge_ulp({1, 0}, {0.5, 0}), 0x1p-52);
  EXPECT_EQ(edge_ulp({1, -7}, {0.5, 0}), 0x1p-50);
  EXPECT_EQ(edge_ulp({0, 0}, {0, 0x1p-1060}), 0x1p-1074);
  EXPECT_EQ(edge_ulp({0x1p1000, 0}, {0, 0}), 0x1p948);
}

TEST(EdgeDistance, OfAVertexOnTheEdgeIsZero) {
  const auto distance = distance_from_edge({0, 0}, {3, 1}, {1.5, 0.5}, 0);
  EXPECT_TRUE(distance.within);
  EXPECT_EQ(distance.ulps, 0);
}

TEST(EdgeDistance, CountsUlpsUpToTheBoundExactly) {
  // Five ulps off a horizontal edge.
  const Point2 p{1, 5 * 0x1p-51};
  EXPECT_TRUE(distance_from_edge({0, 0}, {2, 0}, p, 5).within);
  EXPECT_FALSE(distance_from_edge({0, 0}, {2, 0}, p, std::nextafter(5.0, 0.0)).within);
  EXPECT_DOUBLE_EQ(distance_from_edge({0, 0}, {2, 0}, p, 5).ulps, 5);
}

TEST(EdgeDistance, IsEuclidean) {
  // One off the diagonal in x is 1 / √2 off it.
  const Point2 p{1 + 0x1p-51, 1};
  EXPECT_DOUBLE_EQ(distance_from_edge({0, 0}, {2, 2}, p, 1).ulps, std::sqrt(0.5));
}

TEST(EdgeDistance, SpansTheWholeRangeOfDoubles) {
  const Point2 a{0, 0};
  const Point2 b{0x1p1000, 0x1p-1074};
  EXPECT_TRUE(distance_from_edge(a, b, {0x1p999, 0}, 0x1p-1000).within);
  EXPECT_FALSE(distance_from_edge(a, b, {0x1p999, 0}, 0).within);
  EXPECT_FALSE(distance_from_edge(a, b, {0x1p999, 0x1p999}, 1e6).within);
  EXPECT_TRUE(advances(a, b, {0, 0}, {0, 0x1p-1074}));
  EXPECT_FALSE(advances(a, b, {0, 0x1p-1074}, {0, 0}));
}

TEST(EdgeDistance, AgreesWithRationals) {
  Prng prng(3);
  int near = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto coordinate = [&] {
      return std::ldexp(prng.between(-1, 1), static_cast<int>(prng.below(8)));
    };
    const Point2 a{coordinate(), coordinate()};
    const Point2 b{coordinate(), coordinate()};
    const double t = prng.unit();
    Point2 p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    if (prng.chance(0.5)) p.x = std::nextafter(p.x, 1000);
    const double bound = prng.unit();
    const auto exact = [](double x) { return Rational::exactly(x); };
    const Rational dx = exact(b.x) - exact(a.x);
    const Rational dy = exact(b.y) - exact(a.y);
    const Rational cross = dx * (exact(p.y) - exact(a.y)) - dy * (exact(p.x) - exact(a.x));
    const Rational limit = exact(bound) * exact(edge_ulp(a, b));
    const bool within = cross * cross <= limit * limit * (dx * dx + dy * dy);
    near += within ? 1 : 0;
    const auto distance = distance_from_edge(a, b, p, bound);
    EXPECT_EQ(distance.within, within) << trial;
    const double expected =
        std::sqrt((cross * cross / (dx * dx + dy * dy)).approximate()) / edge_ulp(a, b);
    EXPECT_NEAR(distance.ulps, expected, 1e-9 * expected);
    const Point2 q{prng.chance(0.5) ? p.x : coordinate(), coordinate()};
    const Rational along = dx * (exact(q.x) - exact(p.x)) + dy * (exact(q.y) - exact(p.y));
    EXPECT_EQ(advances(a, b, p, q), along.sign() > 0);
  }
  EXPECT_GT(near, 200);
  EXPECT_LT(near, 1800);
}

}  // namespace
}  // namespace tetloft
