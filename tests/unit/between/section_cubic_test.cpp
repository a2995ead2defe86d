#include "between/section_cubic.hpp"

#include <gtest/gtest.h>

#include <array>

namespace tetloft::testing {

using namespace internal::between;

namespace {

constexpr std::array<double, 3> kShares{0.125, 0.5, 0.75};

TEST(SectionCubic, MeetsTheSectionsAtBothEnds) {
  const Beside beside{1.0, 1.5};
  const std::array<double, 4> p{3, -1, 2, 7};
  EXPECT_EQ(SectionCubic(0, beside).at(p), -1);
  EXPECT_EQ(SectionCubic(1, beside).at(p), 2);
}

TEST(SectionCubic, KeepsWhatIsLinearInHeight) {
  // 3 - 2 z at heights -0.5, 0, 1 and 3.
  const std::array<double, 4> p{4, 3, 1, -3};
  for (const double t : kShares) {
    EXPECT_DOUBLE_EQ(SectionCubic(t, {0.5, 2.0}).at(p), 3 - 2 * t);
    EXPECT_DOUBLE_EQ(SectionCubic(t, {}).at(p), 3 - 2 * t);
  }
}

TEST(SectionCubic, BulgesWhereNeighboursFallOff) {
  EXPECT_DOUBLE_EQ(SectionCubic(0.5, {1.0, 1.0}).at({8, 0, 0, 8}), -1.5);
  EXPECT_DOUBLE_EQ(SectionCubic(0.5, {1.0, 1.0}).at({-8, 0, 0, -8}), 1.5);
}

// Two sections a hair apart tell next to nothing of a wide slab beside them.
TEST(SectionCubic, TrustsASlopeAsFarAsItWasTold) {
  for (const double far : {0x1p-4, 0x1p-10, 0x1p-40}) {
    const double v = SectionCubic(0.5, {far, 1.0}).at({1, 0, 0, 0});
    EXPECT_LT(v, 0);
    EXPECT_GT(v, -0.2);
  }
  EXPECT_DOUBLE_EQ(SectionCubic(0.5, {1.0, 1.0}).at({1, 0, 0, 0}), -0.09375);
}

TEST(SectionCubic, GoesOnAsAParabolaWhereTheStackEnds) {
  EXPECT_DOUBLE_EQ(SectionCubic(0.5, {std::nullopt, 1.0}).at({0, 0, 0, 8}), -1.5);
  EXPECT_DOUBLE_EQ(SectionCubic(0.5, {1.0, std::nullopt}).at({8, 0, 0, 0}), -1.5);
}

TEST(SectionCubic, IsSteepWhereTheClassEndsNextToTheSlab) {
  const Beside goes_on{1.0, 1.0};
  const Beside ends{1.0, 1.0, false, true};
  const std::array<double, 4> p{-9, -6, -2, 1};
  EXPECT_LT(SectionCubic(0.5, ends).at(p), SectionCubic(0.5, goes_on).at(p));
  EXPECT_EQ(SectionCubic(0.5, ends).at({-9, -6, -2, 90}),
            SectionCubic(0.5, goes_on).at({-9, -6, -2, 90}));
}

TEST(SectionCubic, IsTheSameUpsideDown) {
  const std::array<double, 4> p{5, -3, 1.5, 4};
  const std::array<double, 4> q{4, 1.5, -3, 5};
  for (const double t : kShares) {
    EXPECT_DOUBLE_EQ(SectionCubic(t, {0.7, 1.2, true, false}).at(p),
                     SectionCubic(1 - t, {1.2, 0.7, false, true}).at(q));
  }
}

}  // namespace

}  // namespace tetloft::testing
