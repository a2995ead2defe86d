#include "delaunay2/diametral.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "planar_sets.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::internal::delaunay2_detail {
namespace {

int oracle_sign(const Point2& a, const Point2& v, const Point2& b) {
  using oracle::Rational;
  const auto difference = [](double p, double q) {
    return Rational::exactly(p) - Rational::exactly(q);
  };
  return (difference(a.x, v.x) * difference(b.x, v.x) + difference(a.y, v.y) * difference(b.y, v.y))
      .sign();
}

void expect_exact(const Point2& a, const Point2& v, const Point2& b) {
  EXPECT_EQ(static_cast<int>(angle_sign(a, v, b)), oracle_sign(a, v, b));
  EXPECT_EQ(angle_sign(b, v, a), angle_sign(a, v, b));
}

TEST(AngleSign, IsZeroAtRightAngles) {
  EXPECT_EQ(angle_sign({1, 0}, {0, 0}, {0, 1}), Sign::zero);
  EXPECT_EQ(angle_sign({1, 0}, {0, 0}, {1e-300, 1}), Sign::positive);
  EXPECT_EQ(angle_sign({1, 0}, {0, 0}, {-1e-300, 1}), Sign::negative);
  EXPECT_EQ(angle_sign({5, 5}, {5, 5}, {0, 1}), Sign::zero);
}

TEST(AngleSign, AgreesWithRationalsOnTheGrid) {
  const test::Points points = test::lattice(4, 3);
  for (const Point2& a : points) {
    for (const Point2& v : points) {
      for (const Point2& b : points) {
        expect_exact(a, v, b);
        expect_exact({0.1 * a.x, 0.1 * a.y}, {0.1 * v.x, 0.1 * v.y}, {0.1 * b.x, 0.1 * b.y});
      }
    }
  }
}

TEST(AngleSign, AgreesWithRationalsNearRightAngles) {
  Prng prng(1);
  for (int k = 0; k < 1000; ++k) {
    const Point2 v{prng.between(-9, 9), prng.between(-9, 9)};
    const double x = prng.between(-1, 1);
    const double y = prng.between(-1, 1);
    const double length = prng.between(0.1, 10);
    expect_exact({v.x + x, v.y + y}, v, {v.x - y * length, v.y + x * length});
  }
}

TEST(AngleSign, AgreesWithRationalsAtAllScales) {
  Prng prng(2);
  const int ranges[][2] = {{-1073, -1060}, {-560, -500}, {480, 530}, {1010, 1024}, {-1073, 1024}};
  for (const auto& range : ranges) {
    for (int k = 0; k < 100; ++k) {
      const test::Points p = test::scattered_exponents(3, range[0], range[1], prng);
      expect_exact(p[0], p[1], p[2]);
      // Exactly right angles with products that over- or underflow.
      expect_exact({p[0].x, 0}, {0, 0}, {0, p[1].y});
    }
  }
}

}  // namespace
}  // namespace tetloft::internal::delaunay2_detail
