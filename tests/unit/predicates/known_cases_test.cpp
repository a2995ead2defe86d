// Signs that can be told by looking, hard cases of the literature, and special values.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tetloft/predicates.hpp>

namespace tetloft {

namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

TEST(Orient2d, IsPositiveForACounterClockwiseTurn) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::positive);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), Sign::negative);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), Sign::zero);
}

/// Kettner, Mehlhorn, Pion, Schirra and Yap, "Classroom examples of robustness problems in
/// geometric computations", CGTA 40, 2008: the grid of ulps around (0.5, 0.5), where plain
/// arithmetic shows its stripes.
TEST(Orient2d, IsExactOnTheClassroomGrid) {
  const Point2 q{12, 12};
  const Point2 r{24, 24};
  for (int i = 0; i < 64; ++i) {
    for (int k = 0; k < 64; ++k) {
      const Point2 p{0.5 + i * 0x1p-53, 0.5 + k * 0x1p-53};
      // Above the diagonal (y > x) is left of q to r.
      const Sign expected = p.y > p.x ? Sign::positive : p.y < p.x ? Sign::negative : Sign::zero;
      EXPECT_EQ(orient2d(p, q, r), expected) << i << " " << k;
    }
  }
}

TEST(Orient2d, IsExactAtBothEndsOfTheRange) {
  EXPECT_EQ(orient2d({-kMax, -kMax}, {kMax, kMax}, {0, kLeast}), Sign::positive);
  EXPECT_EQ(orient2d({-kMax, -kMax}, {kMax, kMax}, {0, -kLeast}), Sign::negative);
  EXPECT_EQ(orient2d({-kMax, -kMax}, {kMax, kMax}, {kLeast, kLeast}), Sign::zero);
  EXPECT_EQ(orient2d({0, 0}, {kLeast, 0}, {0, kLeast}), Sign::positive);
  EXPECT_EQ(orient2d({0, 0}, {kLeast, kLeast}, {2 * kLeast, 2 * kLeast}), Sign::zero);
}

TEST(Orient3d, IsPositiveForAPositiveTet) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::positive);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Sign::negative);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), Sign::zero);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 2, 3}, {4, 5, 6}, {5, 7, 9}), Sign::zero);
}

TEST(Orient3d, SeesOneUlp) {
  const Point3 a{0.1, 0.2, 0.3}, b{1.1, 0.2, 0.3}, c{0.1, 1.2, 0.3};
  EXPECT_EQ(orient3d(a, b, c, {7, 9, 0.3}), Sign::zero);
  EXPECT_EQ(orient3d(a, b, c, {7, 9, std::nextafter(0.3, 1)}), Sign::positive);
  EXPECT_EQ(orient3d(a, b, c, {7, 9, std::nextafter(0.3, 0)}), Sign::negative);
}

TEST(Orient3d, IsExactAtBothEndsOfTheRange) {
  EXPECT_EQ(orient3d({-kMax, 0, 0}, {kMax, -kMax, 0}, {0, kMax, 0}, {0, 0, kLeast}),
            Sign::positive);
  EXPECT_EQ(orient3d({-kMax, 0, kMax}, {kMax, -kMax, kMax}, {0, kMax, kMax}, {0, 0, -kMax}),
            Sign::negative);
  EXPECT_EQ(orient3d({0, 0, 0}, {kLeast, 0, 0}, {0, kLeast, 0}, {0, 0, kLeast}), Sign::positive);
}

TEST(Incircle, IsPositiveInsideACounterClockwiseTriangle) {
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), Sign::positive);
  EXPECT_EQ(incircle({0, 0}, {0, 1}, {1, 0}, {0.5, 0.5}), Sign::negative);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {2, 2}), Sign::negative);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), Sign::zero);
}

TEST(Incircle, IsZeroForFourCollinearPoints) {
  EXPECT_EQ(incircle({0, 0}, {1, 1}, {2, 2}, {5, 5}), Sign::zero);
  EXPECT_EQ(incircle_perturbed({0, 0}, {1, 1}, {2, 2}, {5, 5}), Sign::zero);
}

TEST(Incircle, SeesOneUlp) {
  const Point2 a{1e6, 0}, b{0, 1e6}, c{-1e6, 0};
  EXPECT_EQ(incircle(a, b, c, {0, -1e6}), Sign::zero);
  EXPECT_EQ(incircle(a, b, c, {kLeast, -1e6}), Sign::negative);
  EXPECT_EQ(incircle(a, b, c, {0, std::nextafter(-1e6, 0)}), Sign::positive);
}

TEST(Insphere, IsPositiveInsideAPositiveTet) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  EXPECT_EQ(insphere(a, b, c, d, {0.5, 0.5, 0.5}), Sign::positive);
  EXPECT_EQ(insphere(a, c, b, d, {0.5, 0.5, 0.5}), Sign::negative);
  EXPECT_EQ(insphere(a, b, c, d, {2, 2, 2}), Sign::negative);
  EXPECT_EQ(insphere(a, b, c, d, {1, 1, 1}), Sign::zero);
}

TEST(Insphere, IsExactAtBothEndsOfTheRange) {
  const Point3 a{kMax, 0, 0}, b{0, kMax, 0}, c{0, 0, kMax}, d{-kMax, 0, 0};
  ASSERT_EQ(orient3d(a, b, c, d), Sign::negative);
  EXPECT_EQ(insphere(a, b, d, c, {0, 0, -kMax}), Sign::zero);
  EXPECT_EQ(insphere(a, b, d, c, {kLeast, 0, -kMax}), Sign::negative);
  EXPECT_EQ(insphere(a, b, d, c, {0, 0, std::nextafter(-kMax, 0)}), Sign::positive);
}

TEST(Insphere, TakesNegativeZeroForZero) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1}, e{1, 1, -0.0};
  EXPECT_EQ(insphere(a, b, c, d, e), Sign::zero);
  EXPECT_EQ(
      insphere_perturbed(a, b, c, d, e),
      insphere_perturbed({-0.0, 0, -0.0}, {1, -0.0, 0}, {-0.0, 1, -0.0}, {0, -0.0, 1}, {1, 1, 0}));
}

}  // namespace

}  // namespace tetloft
