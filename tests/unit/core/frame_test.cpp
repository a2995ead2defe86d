// Where stacks lie.
#include <tetloft/frame.hpp>

#include <gtest/gtest.h>

namespace tetloft {
namespace {

const Frame kExchange{{Point3{0, 0, 1}, Point3{-1, 0, 0}, Point3{0, -1, 0}}, {}};

TEST(Frame, ExchangesCoordinatesWithoutLosingABit) {
  EXPECT_TRUE(is_exact(Frame{}));
  EXPECT_TRUE(is_exact(kExchange));
  EXPECT_EQ(place(kExchange, {0.1, 1e-300, 1e300}), (Point3{-1e-300, -1e300, 0.1}));
  Frame moved = kExchange;
  moved.origin.y = 1;
  EXPECT_FALSE(is_exact(moved));
  EXPECT_EQ(place(moved, {1, 2, 3}), (Point3{-2, -2, 1}));
}

TEST(Frame, ScalesVolumesByItsDeterminant) {
  EXPECT_EQ(volume_factor(Frame{}), 1);
  EXPECT_EQ(volume_factor(kExchange), 1);
  const Frame turned{{Point3{0.6, 0.8, 0}, Point3{-0.8, 0.6, 0}, Point3{0, 0, 1}}, {}};
  EXPECT_EQ(volume_factor(turned), 1);
  EXPECT_FALSE(is_exact(turned));
  const Frame sheared{{Point3{1, 0, 0}, Point3{0.6, 0.8, 0}, Point3{0, 0, 1}}, {}};
  EXPECT_DOUBLE_EQ(volume_factor(sheared), 0.8);
}

}  // namespace
}  // namespace tetloft
