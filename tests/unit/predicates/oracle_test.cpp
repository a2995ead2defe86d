// The oracle itself, against machine integers and algebraic identities.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/prng.hpp"
#include "support/exact/big_int.hpp"
#include "support/exact/predicates.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::oracle {

using namespace internal;

namespace {

std::int64_t small(Prng& prng) {
  const auto bits = static_cast<int>(prng.below(31));
  return static_cast<std::int64_t>(prng.below(std::uint64_t{1} << bits)) *
         (prng.chance(0.5) ? 1 : -1);
}

BigInt large(Prng& prng) {
  BigInt result = small(prng);
  for (std::uint64_t limbs = prng.below(6); limbs > 0; --limbs) {
    result = result.shifted_left(32) + BigInt(static_cast<std::int64_t>(prng.next() >> 32));
  }
  return result;
}

TEST(OracleBigInt, AgreesWithMachineIntegers) {
  Prng prng(1);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t a = small(prng);
    const std::int64_t b = small(prng);
    EXPECT_EQ(BigInt(a) + BigInt(b), BigInt(a + b));
    EXPECT_EQ(BigInt(a) - BigInt(b), BigInt(a - b));
    EXPECT_EQ(BigInt(a) * BigInt(b), BigInt(a * b));
    EXPECT_EQ(BigInt(a) <=> BigInt(b), a <=> b);
    EXPECT_EQ(BigInt(a).approximate(), static_cast<double>(a));
  }
  EXPECT_EQ(BigInt(std::numeric_limits<std::int64_t>::min()).to_string(), "-0x8000000000000000");
}

TEST(OracleBigInt, ObeysTheLawsOfARing) {
  Prng prng(2);
  for (int i = 0; i < 500; ++i) {
    const BigInt a = large(prng);
    const BigInt b = large(prng);
    const BigInt c = large(prng);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ((a + b) * (a - b), a * a - b * b);
    EXPECT_EQ(a - a, BigInt());
    EXPECT_EQ(a.shifted_left(77), a * BigInt(1).shifted_left(77));
    EXPECT_EQ(a.shifted_left(77).shifted_right(77), a);
    EXPECT_EQ(gcd(a * c, b * c), gcd(a, b) * c.abs());
  }
}

TEST(OracleBigInt, TakesDoublesExactly) {
  EXPECT_EQ(BigInt::from_scaled(3, 0), BigInt(3));
  EXPECT_EQ(BigInt::from_scaled(-0.75, -2), BigInt(-3));
  EXPECT_EQ(BigInt::from_scaled(std::numeric_limits<double>::denorm_min(), -1074), BigInt(1));
  EXPECT_EQ(BigInt::from_scaled(std::numeric_limits<double>::max(), -1074).bits(), 2098);
  EXPECT_EQ(BigInt::exponent_of(0.375), -3);
  EXPECT_EQ(BigInt::exponent_of(12), 2);
}

TEST(OracleRational, ComputesInLowestTerms) {
  const Rational third = Rational(1) / Rational(3);
  EXPECT_EQ(third + third + third, Rational(1));
  EXPECT_EQ((Rational(6) / Rational(-4)).to_string(), "-0x3/0x2");
  EXPECT_LT(Rational::exactly(0.1) * Rational(3), Rational::exactly(0.1 * 3));
  EXPECT_GT(Rational::exactly(0.1), Rational(1) / Rational(10));
  EXPECT_EQ((third - Rational(1)).sign(), -1);
}

TEST(OracleRational, ObeysTheLawsOfAField) {
  Prng prng(3);
  for (int i = 0; i < 300; ++i) {
    const Rational a(large(prng), BigInt(1) + large(prng).abs());
    const Rational b(large(prng), BigInt(1) + large(prng).abs());
    EXPECT_EQ((a + b) - b, a);
    if (b.sign() != 0) {
      EXPECT_EQ(a / b * b, a);
    }
    EXPECT_EQ(a <=> b, (a - b).sign() <=> 0);
  }
}

TEST(OracleRational, ApproximatesItsDouble) {
  Prng prng(4);
  for (int i = 0; i < 500; ++i) {
    const double v = std::ldexp(prng.between(-1, 1), static_cast<int>(prng.below(2000)) - 1000);
    const double w = Rational::exactly(v).approximate();
    EXPECT_LE(std::abs(w - v), 0x1p-49 * std::abs(v));
  }
}

TEST(OraclePredicates, TellSimpleSigns) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), 1);
  EXPECT_EQ(insphere({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}), 1);
  // The last point of all is raised most, hence outside.
  EXPECT_EQ(incircle_perturbed({0, 0}, {1, 0}, {0, 1}, {1, 1}), -1);
  EXPECT_EQ(insphere_perturbed({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}), -1);
}

}  // namespace

}  // namespace tetloft::oracle
