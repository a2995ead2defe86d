// The exact arithmetics inside the module, operation by operation, against the oracle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "arithmetic/bounded_integer.hpp"
#include "arithmetic/expansion.hpp"
#include "core/prng.hpp"
#include "predicates/lattice.hpp"
#include "support/exact/big_int.hpp"
#include "support/exact/rational.hpp"

namespace tetloft::internal::predicates {

namespace {

using oracle::BigInt;
using oracle::Rational;

template <int N>
Rational value_of(const Expansion<N>& e) {
  Rational sum;
  for (int i = 0; i < e.size(); ++i) sum = sum + Rational::exactly(e[i]);
  return sum;
}

template <int N>
BigInt value_of(const BoundedInteger<N>& n) {
  BigInt sum;
  for (int i = n.size() - 1; i >= 0; --i) sum = sum.shifted_left(32) + BigInt(std::int64_t{n[i]});
  return n.negative() ? -sum : sum;
}

/// Few-bit mantissas now and then, so that sums cancel and components vanish.
double some_double(Prng& prng) {
  const int exponent = static_cast<int>(prng.below(120)) - 60;
  const double mantissa =
      prng.chance(0.3) ? static_cast<double>(prng.below(4)) : prng.between(-1, 1);
  return std::ldexp(prng.chance(0.5) ? mantissa : -mantissa, exponent);
}

template <int N>
void expect_expansion(const Expansion<N>& e, const Rational& value) {
  EXPECT_EQ(value_of(e), value);
  EXPECT_EQ(e.sign(), value.sign());
  for (int i = 0; i < e.size(); ++i) {
    EXPECT_NE(e[i], 0);
    // Nonoverlapping: the lowest bit of each lies above the highest of the one before.
    if (i == 0) continue;
    EXPECT_LT(std::abs(e[i - 1]), std::ldexp(1.0, BigInt::exponent_of(e[i])));
  }
}

TEST(Expansion, SumsAndProductsAreExact) {
  Prng prng(11);
  for (int trial = 0; trial < 1500; ++trial) {
    const double a = some_double(prng);
    const double b = some_double(prng);
    const double c = prng.chance(0.3) ? a : some_double(prng);
    const double d = prng.chance(0.3) ? -b : some_double(prng);
    const Rational ra = Rational::exactly(a);
    const Rational rb = Rational::exactly(b);
    const Rational rc = Rational::exactly(c);
    const Rational rd = Rational::exactly(d);
    const auto ab = to_expansion(two_difference(a, b));
    const auto cd = to_expansion(two_difference(c, d));
    expect_expansion(ab, ra - rb);
    expect_expansion(to_expansion(a) * to_expansion(b), ra * rb);
    expect_expansion(ab + cd, ra - rb + rc - rd);
    expect_expansion(ab - cd, ra - rb - rc + rd);
    expect_expansion(ab * cd, (ra - rb) * (rc - rd));
    expect_expansion(ab * to_expansion(c), (ra - rb) * rc);
    expect_expansion(to_expansion(c) * ab, (ra - rb) * rc);
    const auto square = ab * cd - cd * ab;
    expect_expansion(square, Rational());
    expect_expansion((ab * cd) * (ab * cd + ab),
                     (ra - rb) * (rc - rd) * ((ra - rb) * (rc - rd) + (ra - rb)));
  }
}

TEST(BigInteger, SumsAndProductsAreExact) {
  Prng prng(12);
  for (int trial = 0; trial < 1500; ++trial) {
    const auto make = [&] {
      return std::ldexp(prng.between(-1, 1), static_cast<int>(prng.below(300)) - 150);
    };
    const double x = make();
    const double y = prng.chance(0.2) ? x : (prng.chance(0.2) ? -x : make());
    const BigCoordinate a = to_big_integer(x, -300);
    const BigCoordinate b = to_big_integer(y, -300);
    const BigInt ra = BigInt::from_scaled(x, -300);
    const BigInt rb = BigInt::from_scaled(y, -300);
    EXPECT_EQ(value_of(a), ra);
    EXPECT_EQ(value_of(a + b), ra + rb);
    EXPECT_EQ(value_of(a - b), ra - rb);
    EXPECT_EQ((a - b).sign(), (ra - rb).sign());
    EXPECT_EQ(value_of(a * b), ra * rb);
    EXPECT_EQ(value_of((a + b) * (a - b)), ra * ra - rb * rb);
  }
}

TEST(BigInteger, HoldsTheWholeRangeOfDoubles) {
  const double largest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(value_of(to_big_integer(largest, -1074)), BigInt::from_scaled(largest, -1074));
  EXPECT_EQ(value_of(to_big_integer(-least, -1074)), BigInt(-1));
  EXPECT_EQ(value_of(to_big_integer(largest, -1074) - to_big_integer(-largest, -1074)),
            BigInt::from_scaled(largest, -1074) * BigInt(2));
}

TEST(Lattice, KeepsRatiosExactly) {
  const auto integers = to_lattice<11>(std::array{1.5, -0.25, 0.0, 255.75});
  ASSERT_TRUE(integers);
  // 255.75 is below 2^8: the unit is 2^-3.
  EXPECT_EQ(*integers, (std::array<std::int64_t, 4>{12, -2, 0, 2046}));
}

TEST(Lattice, RefusesWhatDoesNotFit) {
  EXPECT_TRUE(to_lattice<11>(std::array{1024.0, 1.0}));
  EXPECT_FALSE(to_lattice<11>(std::array{2048.0, 1.0}));
  EXPECT_FALSE(to_lattice<30>(std::array{1.0, 0.1}));
  EXPECT_FALSE(to_lattice<11>(std::array{1.0, 0x1p-1074}));
  EXPECT_FALSE(to_lattice<11>(std::array{0x1p+1000, 0x1p-1074}));
  EXPECT_FALSE(to_lattice<11>(std::array{0.0, 0.0}));
  EXPECT_FALSE(to_lattice<11>(std::array{0x1p-1022, 0x1p-1074}));
  EXPECT_FALSE(to_lattice<11>(std::array{0x1p+1023, 0x1p-1074}));
}

}  // namespace

}  // namespace tetloft::internal::predicates
