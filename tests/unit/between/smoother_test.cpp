#include "between/smoother.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetloft::testing {

using internal::between::Smoother;

namespace {

TEST(Smoother, SpreadsOneValueEvenly) {
  constexpr std::size_t kSide = 41;
  constexpr std::size_t kMiddle = kSide / 2;
  Smoother smoother(3, Smoother::Outside::zero);
  std::vector<double> value(kSide * kSide, 0);
  value[kMiddle * kSide + kMiddle] = 1;
  smoother.smooth(value, kSide, kSide);
  double sum = 0;
  double variance = 0;
  for (std::size_t y = 0; y < kSide; ++y) {
    for (std::size_t x = 0; x < kSide; ++x) {
      const double v = value[y * kSide + x];
      EXPECT_EQ(v, value[y * kSide + (kSide - 1 - x)]);
      EXPECT_EQ(v, value[(kSide - 1 - y) * kSide + x]);
      const double dx = static_cast<double>(x) - kMiddle;
      sum += v;
      variance += v * dx * dx;
      const bool reached = std::abs(dx) <= static_cast<double>(smoother.reach());
      EXPECT_TRUE(reached || v == 0) << x << ' ' << y;
    }
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(variance, 9, 0.5);
}

TEST(Smoother, KeepsWhatIsEvenUpToTheBorder) {
  std::vector<double> value(7 * 3, 2.5);
  Smoother(4, Smoother::Outside::border).smooth(value, 7, 3);
  for (const double v : value) EXPECT_NEAR(v, 2.5, 1e-12);
  Smoother(4, Smoother::Outside::zero).smooth(value, 7, 3);
  for (const double v : value) EXPECT_LT(v, 2);
}

TEST(Smoother, OfNoWidthChangesNothing) {
  std::vector<double> value{1, 5, -2, 4};
  const std::vector<double> before = value;
  Smoother(0, Smoother::Outside::border).smooth(value, 2, 2);
  EXPECT_EQ(value, before);
}

}  // namespace

}  // namespace tetloft::testing
