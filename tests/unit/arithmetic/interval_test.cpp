// Intervals contain the truth; big integers agree with the tests' own.
#include <gtest/gtest.h>

#include <cmath>

#include "arithmetic/big_integer.hpp"
#include "arithmetic/interval.hpp"
#include "core/prng.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using oracle::Rational;

double random_double(Prng& prng) {
  const double value = std::ldexp(prng.between(-1, 1), static_cast<int>(prng.below(60)) - 30);
  switch (prng.below(8)) {
    case 0: return 0;
    case 1: return std::ldexp(value, -1045);  // denormal
    case 2: return std::nearbyint(value);
    default: return value;
  }
}

void expect_contains(const Interval& interval, const Rational& truth) {
  ASSERT_LE(Rational::exactly(interval.lo), truth);
  ASSERT_GE(Rational::exactly(interval.hi), truth);
}

TEST(Interval, ContainsTheTruth) {
  Prng prng(1);
  for (int round = 0; round < 1500; ++round) {
    const double a = random_double(prng);
    const double b = random_double(prng);
    const double c = random_double(prng);
    const Rational x = Rational::exactly(a);
    const Rational y = Rational::exactly(b);
    const Rational z = Rational::exactly(c);
    const Interval d = difference(a, b);
    const Interval f = difference(b, c);
    expect_contains(d, x - y);
    expect_contains(d + f, x - z);
    expect_contains(d - f, x - y - y + z);
    expect_contains(d * f, (x - y) * (y - z));
    expect_contains(absolute(d), (x - y).abs());
    // Quotients by denormals may overflow: not for intervals.
    if (f.lo > 0x1p-100) expect_contains(quotient(d, f), (x - y) / (y - z));
  }
}

TEST(Interval, BoundsAreNextToTheTruth) {
  for (const double x : {1.0, 1.5, 0x1p-1022, 0x1p-1000, 3e-320, 1e300}) {
    for (const double y : {x, -x}) {
      EXPECT_GE(upwards(y), std::nextafter(y, INFINITY));
      EXPECT_LE(downwards(y), std::nextafter(y, -INFINITY));
      EXPECT_LE(std::abs(upwards(y) - y), std::abs(y) * 0x1p-51 + 0x1p-1073);
    }
  }
}

TEST(IntervalSum, StaysNarrow) {
  Prng prng(2);
  IntervalSum sum;
  Rational truth;
  for (int k = 0; k < 5000; ++k) {
    const double a = prng.unit();
    truth = truth + Rational::exactly(a);
    sum.add({a, a});
  }
  expect_contains(sum.total(), truth);
  EXPECT_LT(sum.total().hi - sum.total().lo, sum.total().hi * 40 * 0x1p-52);
}

// The same value in both arithmetics, from random digits.
struct Pair {
  BigInteger ours;
  oracle::BigInt theirs;
};

Pair random_pair(Prng& prng) {
  Pair p{BigInteger(0), oracle::BigInt(0)};
  const std::uint64_t digits = prng.below(11);
  for (std::uint64_t k = 0; k < digits; ++k) {
    // Long runs of zeros and ones exercise carries and borrows.
    const auto kind = prng.below(4);
    const std::int64_t digit = kind == 0   ? 0
                               : kind == 1 ? std::int64_t{0xFFFFFFFF}
                                           : static_cast<std::int64_t>(prng.below(1ULL << 32));
    p.ours = (p.ours << 32) + BigInteger(digit);
    p.theirs = p.theirs.shifted_left(32) + oracle::BigInt(digit);
  }
  if (prng.chance(0.5)) {
    p.ours = -p.ours;
    p.theirs = -p.theirs;
  }
  return p;
}

void expect_equal(const BigInteger& ours, const oracle::BigInt& theirs) {
  ASSERT_EQ(ours.sign(), theirs.sign());
  ASSERT_EQ(ours.bits(), static_cast<std::size_t>(theirs.bits()));
  // Digit by digit, from the top.
  BigInteger rest = ours.sign() < 0 ? -ours : ours;
  oracle::BigInt other = theirs.abs();
  while (other.sign() != 0) {
    const int bit = other.bits() - 1;
    rest = rest - (BigInteger(1) << static_cast<std::size_t>(bit));
    other = other - oracle::BigInt(1).shifted_left(bit);
    ASSERT_EQ(rest.bits(), static_cast<std::size_t>(other.bits()));
  }
}

TEST(BigInteger, AgreesWithTheOracle) {
  Prng prng(3);
  for (int round = 0; round < 400; ++round) {
    const Pair a = random_pair(prng);
    const Pair b = random_pair(prng);
    expect_equal(a.ours + b.ours, a.theirs + b.theirs);
    expect_equal(a.ours - b.ours, a.theirs - b.theirs);
    expect_equal(a.ours * b.ours, a.theirs * b.theirs);
    const std::size_t shift = prng.below(200);
    expect_equal(a.ours << shift, a.theirs.shifted_left(static_cast<int>(shift)));
    ASSERT_EQ(a.ours < b.ours, a.theirs < b.theirs);
    ASSERT_EQ(a.ours == b.ours, a.theirs == b.theirs);
    ASSERT_DOUBLE_EQ(a.ours.to_double(), a.theirs.approximate());
  }
}

TEST(BigInteger, TakesDoublesOfAllMagnitudes) {
  for (const double x : {0.0, 1.0, -3.0, 0x1p-1074, 0x1.8p1000, 0.1, -1e-310}) {
    const BigInteger value = BigInteger::from_double(x, -1074);
    EXPECT_DOUBLE_EQ(value.to_double(-1074), x);
  }
  EXPECT_EQ((BigInteger(1) << 5000).to_double(), std::numeric_limits<double>::infinity());
  EXPECT_EQ((BigInteger(1) << 50).to_double(-5000), 0);
}

TEST(BigInteger, TakesTheLowest128BitInteger) {
  const Int128 lowest = -(static_cast<Int128>(1) << 126) * 2;
  EXPECT_EQ(-BigInteger(lowest), BigInteger(1) << 127);
}

}  // namespace
}  // namespace tetloft::testing
