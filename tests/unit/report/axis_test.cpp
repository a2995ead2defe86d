// Ticks are round, and what is shown is in the axis.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "report/axis.hpp"

namespace tetloft::internal::report {
namespace {

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> texts;
  for (const Tick& tick : axis.ticks()) texts.push_back(tick.label);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(Axis, TicksAreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(labels(Axis(0, 100, Scale::linear, 5, true)),
            (Texts{"0", "20", "40", "60", "80", "100"}));
  EXPECT_EQ(labels(Axis(0, 180, Scale::linear, 6, false)),
            (Texts{"0", "20", "40", "60", "80", "100", "120", "140", "160", "180"}));
  EXPECT_EQ(labels(Axis(-0.3, 0.25, Scale::linear, 4, false)),
            (Texts{"−0.3", "−0.2", "−0.1", "0", "0.1", "0.2"}));
  EXPECT_EQ(labels(Axis(0, 200000, Scale::linear, 4, true)),
            (Texts{"0", "50\u202F000", "100\u202F000", "150\u202F000", "200\u202F000"}));
}

TEST(Axis, IsWidenedToTicksWhereThatIsAskedFor) {
  const Axis wide(0, 93, Scale::linear, 5, true);
  EXPECT_EQ(wide.high(), 100);
  EXPECT_EQ(wide.position(0), 0);
  EXPECT_DOUBLE_EQ(wide.position(93), 0.93);
  const Axis tight(7, 93, Scale::linear, 5, false);
  EXPECT_EQ(tight.low(), 7);
  EXPECT_EQ(tight.high(), 93);
  EXPECT_EQ(labels(tight), (Texts{"20", "40", "60", "80"}));
}

TEST(Axis, HoldsOneValueInTheMiddle) {
  for (const double value : {5.0, -5.0, 1e300, 1e-300, -2e-308, 1e17}) {
    const Axis axis(value, value, Scale::linear, 5, false);
    EXPECT_NEAR(axis.position(value), 0.5, 1e-6) << value;
    EXPECT_LT(axis.low(), axis.high());
    EXPECT_FALSE(axis.ticks().empty()) << value;
  }
  const Axis zero(0, 0, Scale::linear, 5, true);
  EXPECT_EQ(zero.position(0), 0);
}

TEST(Axis, TakesAnyFiniteNumbers) {
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const auto& [low, high] : std::vector<std::pair<double, double>>{{-largest, largest},
                                                                        {0, largest},
                                                                        {0, least},
                                                                        {-least, 3 * least},
                                                                        {1, 1 + 1e-15},
                                                                        {1e300, 2e300},
                                                                        {1e-310, 2e-310},
                                                                        {0, 1e-323}}) {
    for (const bool to_ticks : {false, true}) {
      const Axis axis(low, high, Scale::linear, 5, to_ticks);
      ASSERT_LE(axis.ticks().size(), 13U) << low << ' ' << high;
      ASSERT_GE(axis.ticks().size(), 1U) << low << ' ' << high;
      double before = -1;
      for (const Tick& tick : axis.ticks()) {
        const double at = axis.position(tick.value);
        EXPECT_GE(at, before) << low << ' ' << high;
        EXPECT_LE(at, 1);
        before = at;
      }
    }
  }
}

TEST(Axis, LogarithmicTicksArePowersOfTen) {
  EXPECT_EQ(labels(Axis(0.0005, 200, Scale::logarithmic, 6, false)),
            (Texts{"0.001", "0.01", "0.1", "1", "10", "100"}));
  EXPECT_EQ(labels(Axis(0.9, 60, Scale::logarithmic, 6, false)),
            (Texts{"1", "2", "5", "10", "20", "50"}));
  const Axis axis(1, 10000, Scale::logarithmic, 6, false);
  EXPECT_DOUBLE_EQ(axis.position(100), 0.5);
  const Axis wide(1e-300, 1e300, Scale::logarithmic, 6, false);
  EXPECT_LE(wide.ticks().size(), 8U);
  EXPECT_GE(wide.ticks().size(), 4U);
}

TEST(Axis, ShortLogarithmicIntervalsStandLinearly) {
  const Axis axis(3.0, 3.4, Scale::logarithmic, 5, false);
  EXPECT_EQ(labels(axis), (Texts{"3", "3.1", "3.2", "3.3", "3.4"}));
  EXPECT_NEAR(axis.position(3.2), 0.5, 1e-12);
  const Axis one(7, 7, Scale::logarithmic, 6, false);
  EXPECT_DOUBLE_EQ(one.position(7), 0.5);
}

TEST(RoundDown, IsTheLargestRoundNumberUpToALength) {
  EXPECT_EQ(round_down(1), 1);
  EXPECT_EQ(round_down(0.99), 0.5);
  EXPECT_EQ(round_down(4.999), 2);
  EXPECT_EQ(round_down(5), 5);
  EXPECT_EQ(round_down(1999), 1000);
  EXPECT_EQ(round_down(2000), 2000);
  EXPECT_EQ(round_down(7e-9), 5e-9);
  EXPECT_EQ(round_down(std::numeric_limits<double>::max()), 1e308);
  for (const double length : {1e-323, 3e-320, 1e-308, 1e-5, 123.0, 1e307}) {
    EXPECT_LE(round_down(length), length);
    EXPECT_GT(round_down(length), length / 3) << length;
  }
}

TEST(NumberText, IsWhatPeopleWrite) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0), "0");
  EXPECT_EQ(number_text(12.3456789), "12.346");
  EXPECT_EQ(number_text(12.3456789, 3), "12.3");
  EXPECT_EQ(number_text(-4), "−4");
  EXPECT_EQ(number_text(1234), "1234");
  EXPECT_EQ(number_text(12345.6), "12\u202F346");
  EXPECT_EQ(number_text(0.00012), "0.00012");
  EXPECT_EQ(number_text(3.1e-9), "3.1·10⁻⁹");
  EXPECT_EQ(number_text(6.02214e23), "6.0221·10²³");
  EXPECT_EQ(number_text(9.9999999, 3), "10");
  EXPECT_EQ(number_text(std::nan("")), "–");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "∞");
}

}  // namespace
}  // namespace tetloft::internal::report
