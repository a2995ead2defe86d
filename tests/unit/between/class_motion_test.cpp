#include "between/class_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include <cstdint>
#include <optional>

#include "unit/between/class_shapes.hpp"

namespace tetloft::testing {

using namespace internal::between;

namespace {

// Where the middle of the slab is met by a disc that moves by (6, 3) a gap.
constexpr Point2 kMiddle{3, 1.5};

OwnedClass moving_disc() { return discs({{{-6, -3}, {0, 0}, {6, 3}, {12, 6}}}, {4, 4, 4, 4}); }

TEST(ClassMotion, FollowsADisc) {
  const std::optional<MotionField> motion = estimate_motion(moving_disc().outlines());
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->at(kMiddle).x, 6, 1.5);
  EXPECT_NEAR(motion->at(kMiddle).y, 3, 1);
}

TEST(ClassMotion, OfOneSectionIsThatOfTheSlabBeside) {
  OwnedClass end = moving_disc();
  end.contours[upper].clear();
  end.contours[beyond].clear();
  const std::optional<MotionField> motion = estimate_motion(end.outlines());
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->at(kMiddle).x, 6, 1.5);
  EXPECT_NEAR(motion->at(kMiddle).y, 3, 1);
}

TEST(ClassMotion, PartsFollowEachTheirOwn) {
  OwnedClass fork = moving_disc();
  for (const Around s : {behind, lower, upper, beyond}) {
    const double x = 60 - 5 * (static_cast<double>(s) - 1);
    fork.contours[s].push_back(circle({x, 0}, 4));
  }
  const std::optional<MotionField> motion = estimate_motion(fork.outlines());
  ASSERT_TRUE(motion);
  EXPECT_GT(motion->at(kMiddle).x, 4.5);
  EXPECT_LT(motion->at({57.5, 0}).x, -3.5);
}

TEST(ClassMotion, IsNoneAtRestOrWhereNothingTells) {
  EXPECT_FALSE(estimate_motion(discs({}, {7, 8, 8.05, 9}).outlines()));
  EXPECT_FALSE(estimate_motion(discs({}, {0, 8, 0, 0}).outlines()));
  EXPECT_FALSE(estimate_motion(discs({}, {0, 0, 8, 0}).outlines()));
}

TEST(ClassMotion, DoesNotDependOnWhatIsFarAway) {
  // A disc far to the lower left moves the window, and with it the tiles.
  OwnedClass two = moving_disc();
  for (std::vector<Contour>& contours : two.contours) {
    contours.push_back(circle({-211.7, -93.1}, 5));
  }
  const std::optional<MotionField> one = estimate_motion(moving_disc().outlines());
  const std::optional<MotionField> both = estimate_motion(two.outlines());
  ASSERT_TRUE(one && both);
  EXPECT_EQ(one->spacing, both->spacing);
  for (std::int64_t j = -1; j <= 2; ++j) {
    for (std::int64_t i = -1; i <= 3; ++i) {
      EXPECT_EQ(one->node[one->window.place(i, j)], both->node[both->window.place(i, j)]);
    }
  }
}

TEST(ClassMotion, IsBilinearInsideAndThatOfTheBorderOutside) {
  const MotionField field{{0, 0, 2, 2}, 2, {{0, 0}, {4, 0}, {0, 8}, {4, 8}}};
  EXPECT_EQ(field.at({0.5, 1.5}), (Point2{1, 6}));
  EXPECT_EQ(field.at({2, 2}), (Point2{4, 8}));
  EXPECT_EQ(field.at({-5, 1}), (Point2{0, 4}));
  EXPECT_EQ(field.at({99, 99}), (Point2{4, 8}));
}

TEST(MotionField, IsTheSameAtAllSamplesAtOnce) {
  MotionField field{{-2, -1, 4, 3}, 1.7, {}};
  for (std::size_t k = 0; k < field.window.size(); ++k) {
    const auto t = static_cast<double>(k);
    field.node.push_back({std::sin(t), std::cos(3 * t)});
  }
  const internal::motion::LatticeWindow samples{-19, -11, 23, 17};
  const std::vector<Point2> all = field.at_samples(samples, 0.31);
  for (std::int64_t j = samples.j0; j < samples.j1; ++j) {
    for (std::int64_t i = samples.i0; i < samples.i1; ++i) {
      EXPECT_EQ(all[samples.place(i, j)],
                field.at({static_cast<double>(i) * 0.31, static_cast<double>(j) * 0.31}));
    }
  }
}

}  // namespace

}  // namespace tetloft::testing
