#include "core/union_find.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

TEST(UnionFind, StartsWithEveryElementAlone) {
  const UnionFind sets(4);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
  EXPECT_FALSE(sets.same(0, 3));
}

TEST(UnionFind, UniteTellsWhetherItChangedAnything) {
  UnionFind sets(3);
  EXPECT_TRUE(sets.unite(2, 1));
  EXPECT_FALSE(sets.unite(1, 2));
  EXPECT_FALSE(sets.unite(0, 0));
}

TEST(UnionFind, RepresentativeIsTheSmallestElement) {
  UnionFind sets(6);
  sets.unite(5, 4);
  sets.unite(4, 2);
  EXPECT_EQ(sets.find(5), 2U);
  sets.unite(3, 1);
  sets.unite(5, 3);
  for (const std::size_t i : {1U, 2U, 3U, 4U, 5U}) EXPECT_EQ(sets.find(i), 1U);
  EXPECT_EQ(sets.find(0), 0U);
}

TEST(UnionFind, AgreesWithRelabelling) {
  Prng prng(7);
  for (int trial = 0; trial < 20; ++trial) {
    const std::size_t n = 1 + prng.below(40);
    UnionFind sets(n);
    std::vector<std::size_t> label(n);
    for (std::size_t i = 0; i < n; ++i) label[i] = i;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = prng.below(n);
      const std::size_t j = prng.below(n);
      EXPECT_EQ(sets.unite(i, j), label[i] != label[j]);
      const auto [low, high] =
          std::pair(std::min(label[i], label[j]), std::max(label[i], label[j]));
      for (std::size_t& l : label) l = l == high ? low : l;
    }
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(sets.find(i), label[i]);
  }
}

}  // namespace
}  // namespace tetloft
