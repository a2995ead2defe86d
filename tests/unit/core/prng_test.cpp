#include "core/prng.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tetloft {

using namespace internal;
namespace {

TEST(Prng, YieldsTheReferenceSequenceOfSplitMix64) {
  // The first outputs for seed 1234567, as widely published with the algorithm.
  Prng prng(1234567);
  EXPECT_EQ(prng.next(), 6457827717110365317ULL);
  EXPECT_EQ(prng.next(), 3203168211198807973ULL);
  EXPECT_EQ(prng.next(), 9817491932198370423ULL);
  EXPECT_EQ(prng.next(), 4593380528125082431ULL);
  EXPECT_EQ(prng.next(), 16408922859458223821ULL);
}

TEST(Prng, BelowStaysBelowAndReachesAll) {
  Prng prng(1);
  std::array<int, 5> hits{};
  for (int i = 0; i < 1000; ++i) ++hits.at(prng.below(5));
  for (const int count : hits) EXPECT_GT(count, 100);
}

TEST(Prng, UnitIsAMultipleOfTwoToTheMinus53BelowOne) {
  Prng prng(2);
  for (int i = 0; i < 1000; ++i) {
    const double u = prng.unit();
    EXPECT_GE(u, 0);
    EXPECT_LT(u, 1);
    EXPECT_EQ(u * 0x1p53, static_cast<double>(static_cast<std::uint64_t>(u * 0x1p53)));
  }
}

TEST(Prng, ChanceOfZeroNeverAndOfOneAlways) {
  Prng prng(3);
  for (int i = 0; i < 100; ++i) {
    EXPECT_FALSE(prng.chance(0));
    EXPECT_TRUE(prng.chance(1));
  }
}

TEST(Prng, ShufflePermutesTheSameWayForTheSameSeed) {
  std::vector<int> first(50);
  std::iota(first.begin(), first.end(), 0);
  const std::vector<int> sorted = first;
  std::vector<int> second = first;
  Prng(4).shuffle(first);
  Prng(4).shuffle(second);
  EXPECT_EQ(first, second);
  EXPECT_NE(first, sorted);
  std::sort(first.begin(), first.end());
  EXPECT_EQ(first, sorted);
}

}  // namespace
}  // namespace tetloft
