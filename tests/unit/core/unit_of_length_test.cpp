#include "core/unit_of_length.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

int unit_exponent(const std::vector<double>& numbers) {
  UnitOfLength unit;
  for (const double x : numbers) unit.include(x);
  return unit.exponent();
}

// A double of up to 53 bits with its highest bit at 2^exponent.
double random_number(Prng& prng, int exponent) {
  const double mantissa = 1 + std::ldexp(static_cast<double>(prng.below(1ULL << 52)), -52);
  return std::ldexp(prng.below(2) == 0 ? mantissa : -mantissa, exponent);
}

TEST(UnitOfLength, LargestNumberIsNearOne) {
  EXPECT_EQ(unit_exponent({3, 0.25, -7}), -2);
  EXPECT_EQ(unit_exponent({0x1p-900, 0}), 900);
  EXPECT_EQ(unit_exponent({0x1p999}), -999);
  EXPECT_EQ(unit_exponent({}), 0);
  EXPECT_EQ(unit_exponent({0, -0.0}), 0);
  EXPECT_EQ(unit_exponent({1, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}),
            0);
}

TEST(UnitOfLength, NumbersKeepAllBitsAndMultiplesAreTheSameInTheirUnit) {
  Prng prng(11);
  std::size_t far_apart = 0;
  std::size_t multiples = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<double> numbers;
    const int lowest = -1074 + static_cast<int>(prng.below(2000));
    const int spread = static_cast<int>(prng.below(static_cast<std::uint64_t>(1000 - lowest)));
    for (int k = 0; k < 4; ++k) {
      const auto above = static_cast<int>(prng.below(static_cast<std::uint64_t>(spread) + 1));
      numbers.push_back(random_number(prng, lowest + above));
    }
    const int exponent = unit_exponent(numbers);
    double largest = 0;
    for (const double x : numbers) {
      EXPECT_TRUE(is_scaled_exactly(x, exponent)) << x << " times 2^" << exponent;
      largest = std::max(largest, std::abs(std::ldexp(x, exponent)));
    }
    EXPECT_TRUE(largest == 0 || (largest >= 1 && largest < 0x1p1000));
    if (largest >= 2) ++far_apart;

    const int k = static_cast<int>(prng.below(2000)) - 1000;
    std::vector<double> others;
    bool exact = true;
    for (const double x : numbers) {
      exact = exact && is_scaled_exactly(x, k) && std::abs(std::ldexp(x, k)) < 0x1p1000;
      others.push_back(std::ldexp(x, k));
    }
    if (!exact || largest == 0) continue;
    EXPECT_EQ(unit_exponent(others), exponent - k);
    ++multiples;
  }
  EXPECT_GT(far_apart, 1000U);
  EXPECT_GT(multiples, 1000U);
}

TEST(Scaled, IsLdexpForAllExponents) {
  Prng prng(12);
  for (int exponent = -2200; exponent <= 2200; ++exponent) {
    for (int at = -1074; at < 1024; at += 37) {
      const double x = random_number(prng, at);
      ASSERT_EQ(scaled(x, exponent), std::ldexp(x, exponent)) << x << " times 2^" << exponent;
    }
  }
}

TEST(UnitOfLength, NumbersThatMeetBothEndsOfTheRangeStayAsTheyAre) {
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(unit_exponent({0x1.8p999, least}), 0);
}

}  // namespace
}  // namespace tetloft
