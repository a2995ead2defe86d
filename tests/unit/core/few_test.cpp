// Sets of a few ids, and lists of a few items sorted: the few, and more than that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>

#include "core/id_set.hpp"
#include "core/prng.hpp"
#include "core/sort_few.hpp"

namespace tetloft {

using namespace internal;
namespace {

// Of a range so small that many come again; as many as the first table holds, and more. One set for
// all, so that what clear() leaves would show.
TEST(IdSet, HoldsEachIdOnceInOrderAndIsEmptyWhenCleared) {
  Prng prng(17);
  IdSet<VertexId> set;
  for (const std::size_t draws : {10U, 60U, 64U, 65U, 1000U, 3U, 300U}) {
    std::set<VertexId> expected;
    std::vector<VertexId> in_order;
    for (std::size_t i = 0; i < draws; ++i) {
      const VertexId id(prng.below(2 * draws) * 1000);
      const bool is_new = expected.insert(id).second;
      if (is_new) in_order.push_back(id);
      ASSERT_EQ(set.insert(id), is_new) << draws;
    }
    EXPECT_EQ(set.ids(), in_order);
    for (std::size_t i = 0; i < 2 * draws; ++i) {
      const VertexId id(i * 1000);
      EXPECT_EQ(set.contains(id), expected.count(id) != 0) << draws;
    }
    set.clear();
    EXPECT_TRUE(set.ids().empty());
    for (const VertexId id : in_order) ASSERT_FALSE(set.contains(id)) << draws;
  }
}

TEST(SortFew, SortsListsOfEveryLength) {
  Prng prng(18);
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<std::size_t> list(n);
    for (std::size_t& item : list) item = prng.below(30);
    std::vector<std::size_t> expected = list;
    std::sort(expected.begin(), expected.end());
    sort_few(std::span(list));
    EXPECT_EQ(list, expected);
    std::reverse(expected.begin(), expected.end());
    sort_few(std::span(list), [](std::size_t a, std::size_t b) { return a > b; });
    EXPECT_EQ(list, expected);
  }
}

}  // namespace
}  // namespace tetloft
