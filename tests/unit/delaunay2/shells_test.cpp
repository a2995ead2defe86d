#include "delaunay2/shells.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/prng.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::internal::delaunay2_detail {
namespace {

using oracle::Rational;

Rational distance(double a, const Rational& b) { return (Rational::exactly(a) - b).abs(); }

TEST(Midpoint, IsRoundedOnce) {
  Prng prng(1);
  const int exponents[] = {-1073, -1070, -1021, 0, 1, 50, 1022, 1023};
  for (int k = 0; k < 4000; ++k) {
    double value[2];
    for (double& v : value) {
      v = std::ldexp(prng.between(1, 2), exponents[prng.below(8)]) * (prng.chance(0.5) ? 1 : -1);
    }
    const double middle = midpoint({value[0], 0}, {value[1], 0}).x;
    const Rational exact =
        (Rational::exactly(value[0]) + Rational::exactly(value[1])) / Rational(2);
    const Rational error = distance(middle, exact);
    for (const double toward : {-1.0, 1.0}) {
      const double other = std::nextafter(middle, toward * INFINITY);
      if (std::isfinite(other)) {
        EXPECT_LE(error, distance(other, exact));
      }
    }
  }
}

TEST(Midpoint, DoesNotOverflow) {
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(midpoint({largest, -largest}, {largest, largest}), (Point2{largest, 0}));
}

TEST(RoundestBetween, FromTheCornerIsThePowerOfTwoNearestToTheMiddle) {
  EXPECT_EQ(roundest_between(0, 1), 0.5);
  EXPECT_EQ(roundest_between(0, 8), 4);
  EXPECT_EQ(roundest_between(0, 5.9), 2);
  EXPECT_EQ(roundest_between(0, 6.1), 4);
  EXPECT_EQ(roundest_between(11, 0), 4);
}

TEST(RoundestBetween, IsInTheMiddleThirdAndNothingThereIsRounder) {
  Prng prng(2);
  for (int k = 0; k < 1000; ++k) {
    const double a = prng.chance(0.3) ? 0 : std::ldexp(prng.unit(), -int(prng.below(20)));
    const double b = a + std::ldexp(prng.between(1, 2), -int(prng.below(20)));
    const double low = std::min(a, b) + std::abs(b - a) / 3;
    const double high = std::max(a, b) - std::abs(b - a) / 3;
    const double roundest = roundest_between(a, b);
    EXPECT_EQ(roundest, roundest_between(b, a));
    EXPECT_GE(roundest, low);
    EXPECT_LE(roundest, high);
    const double unit = std::ldexp(1, Rational::exactly(roundest).numerator().trailing_zeros() -
                                          Rational::exactly(roundest).denominator().bits() + 1);
    EXPECT_LT(std::floor(high / (2 * unit)) * 2 * unit, low);
  }
}

TEST(RoundestBetween, EndsWithoutRoom) {
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_GE(roundest_between(1, next), 1);
  EXPECT_LE(roundest_between(1, next), next);
  EXPECT_EQ(roundest_between(0, 0), 0);
  EXPECT_GE(roundest_between(0, 0x1p-1074), 0);
}

TEST(LiesBetween, NeedsOneStrictCoordinateInsideTheBox) {
  EXPECT_TRUE(lies_between({0, 0}, {1, 1}, {2, 2}));
  EXPECT_TRUE(lies_between({0, 0}, {0, 1}, {0, 2}));
  EXPECT_TRUE(lies_between({2, 0}, {1, 0}, {0, 0}));
  EXPECT_FALSE(lies_between({0, 0}, {0, 0}, {2, 2}));
  EXPECT_FALSE(lies_between({0, 0}, {2, 2}, {2, 2}));
  EXPECT_FALSE(lies_between({0, 0}, {2, 0}, {2, 2}));
  EXPECT_FALSE(lies_between({0, 0}, {1, 3}, {2, 2}));
  EXPECT_FALSE(lies_between({0, 0}, {-1, 1}, {2, 2}));
}

TEST(Ray, StaysWithinTwoUlpsOfItsSegment) {
  Prng prng(3);
  for (int k = 0; k < 500; ++k) {
    const int scale = int(prng.below(4)) * 300 - 500;
    const auto draw = [&] { return std::ldexp(prng.between(-1, 1), scale - int(prng.below(40))); };
    const Point2 a{draw(), draw()};
    const Point2 b{draw(), draw()};
    const Ray ray(a, b);
    EXPECT_EQ(ray.at(0), a);
    const double fraction = prng.unit();
    const Point2 c = ray.at(fraction * ray.length());
    const auto check = [&](double from, double to, double cross, double cross_from,
                           double cross_to) {
      // Where the exact line has the other coordinate of c, it has this one up to 2 ulps of
      // this axis and 2 of the other, carried over by the slope.
      const Rational slope = (Rational::exactly(to) - Rational::exactly(from)) /
                             (Rational::exactly(cross_to) - Rational::exactly(cross_from));
      const Rational on_line = Rational::exactly(from) +
                               slope * (Rational::exactly(cross) - Rational::exactly(cross_from));
      const auto ulp = [](double u, double v) {
        const double m = std::max(std::abs(u), std::abs(v));
        return Rational::exactly(std::nextafter(m, INFINITY) - m);
      };
      return std::pair{on_line, Rational(2) * ulp(from, to) +
                                    Rational(2) * slope.abs() * ulp(cross_from, cross_to)};
    };
    const auto [y, tolerance] = check(a.y, b.y, c.x, a.x, b.x);
    EXPECT_LE(distance(c.y, y), tolerance);
  }
}

TEST(Ray, IsMonotone) {
  Prng prng(4);
  const Ray ray({1, 3}, {1 + 0x1p-50, 4});
  Point2 last = ray.at(0);
  for (int i = 1; i <= 1000; ++i) {
    const Point2 p = ray.at(ray.length() * i / 1000);
    EXPECT_LE(last.x, p.x);
    EXPECT_LT(last.y, p.y);
    last = p;
  }
}

TEST(Ray, MeasuresLengthsOfAnyScale) {
  for (const int exponent : {-1070, -600, 0, 600, 1000}) {
    const double unit = std::ldexp(1, exponent);
    EXPECT_EQ(Ray({0, 0}, {3 * unit, 4 * unit}).length(), 1.25);
    EXPECT_EQ(Ray({0, -4 * unit}, {3 * unit, -8 * unit}).length(), 1.25);
  }
}

}  // namespace
}  // namespace tetloft::internal::delaunay2_detail
