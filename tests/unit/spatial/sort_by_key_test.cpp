#include "spatial/sort_by_key.hpp"

#include <gtest/gtest.h>

#include "core/prng.hpp"

namespace tetloft::internal::core {
namespace {

void expect_sorted(std::vector<Keyed> entries) {
  std::vector<Keyed> expected = entries;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
  sort_by_key(entries);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    ASSERT_EQ(entries[i].key, expected[i].key) << i;
    ASSERT_EQ(entries[i].place, expected[i].place) << i;
  }
}

// Few and many entries, with keys of all bits, of high bits only, and of few values.
TEST(SortByKey, SortsByKeyThenPlace) {
  Prng prng(7);
  for (const std::size_t n : {0U, 1U, 2U, 16U, 17U, 100U, 2000U, 30000U}) {
    for (const std::uint64_t mask :
         {~std::uint64_t{0}, std::uint64_t{0xFF} << 56, std::uint64_t{7} << 10, std::uint64_t{0}}) {
      std::vector<Keyed> entries(n);
      for (std::uint32_t i = 0; i < n; ++i) entries[i] = {prng.next() & mask, i};
      expect_sorted(entries);
    }
  }
}

// Each bucket but one is a bucket within another.
TEST(SortByKey, SortsKeysThatCrowdAroundOneMoreAndMore) {
  Prng prng(8);
  std::vector<Keyed> entries(20000);
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    entries[i] = {prng.next() >> prng.below(64), i};
  }
  expect_sorted(entries);
}

}  // namespace
}  // namespace tetloft::internal::core
