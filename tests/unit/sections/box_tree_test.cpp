// The box tree finds exactly the boxes that meet a query.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/prng.hpp"
#include "sections/box_tree.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using sections::Box;
using sections::BoxTree;

Box random_box(Prng& prng, double size) {
  const double x = prng.between(0, 100);
  const double y = prng.between(0, 100);
  return {x, y, x + prng.between(0, size), y + prng.between(0, size)};
}

TEST(BoxTree, FindsWhatASearchOfAllFinds) {
  Prng prng(1);
  for (const std::size_t n : {0U, 1U, 7U, 8U, 9U, 64U, 65U, 1000U, 5000U}) {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < n; ++k) boxes.push_back(random_box(prng, k % 50 == 0 ? 80 : 3));
    const BoxTree tree(boxes);
    for (int round = 0; round < 50; ++round) {
      const Box query = random_box(prng, 20);
      std::vector<std::size_t> found;
      tree.query(query, [&](std::size_t k) { found.push_back(k); });
      std::sort(found.begin(), found.end());
      std::vector<std::size_t> expected;
      for (std::size_t k = 0; k < n; ++k) {
        if (boxes[k].meets(query)) expected.push_back(k);
      }
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, FindsTheNearest) {
  Prng prng(2);
  for (const std::size_t n : {0U, 1U, 8U, 9U, 65U, 1000U, 5000U}) {
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < n; ++k) boxes.push_back(random_box(prng, k % 50 == 0 ? 80 : 3));
    const BoxTree tree(boxes);
    std::size_t visited = 0;
    for (int round = 0; round < 50; ++round) {
      const Point2 p{prng.between(-50, 150), prng.between(-50, 150)};
      const auto offset = [&](std::size_t k) {
        const Point2 of = boxes[k].offset(p);
        return std::max(of.x, of.y);
      };
      double expected = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < n; ++k) expected = std::min(expected, offset(k));
      double found = std::numeric_limits<double>::infinity();
      tree.query_nearest(
          p,
          [&](std::size_t k) {
            found = std::min(found, offset(k));
            ++visited;
          },
          [&] { return found; });
      ASSERT_EQ(found, expected);
    }
    EXPECT_LE(visited, 50 * (100 + n / 10));
  }
}

TEST(Box, MeetsClosedAndOverlapsOpen) {
  const Box box{0, 0, 2, 2};
  EXPECT_TRUE(box.meets({2, 2, 3, 3}));
  EXPECT_FALSE(box.overlaps({2, 0, 3, 2}));
  EXPECT_TRUE(box.overlaps({1, 1, 3, 3}));
  EXPECT_FALSE(Box{}.meets(box));
}

}  // namespace
}  // namespace tetloft::testing
