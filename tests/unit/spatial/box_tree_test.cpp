// The box tree finds exactly the boxes that meet a query.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/prng.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Box2 random_box(Prng& prng, double size) {
  const double x = prng.between(0, 100);
  const double y = prng.between(0, 100);
  return {x, y, x + prng.between(0, size), y + prng.between(0, size)};
}

TEST(BoxTree2, FindsWhatASearchOfAllFinds) {
  Prng prng(1);
  for (const std::size_t n : {0U, 1U, 7U, 8U, 9U, 64U, 65U, 1000U, 5000U}) {
    std::vector<Box2> boxes;
    for (std::size_t k = 0; k < n; ++k) boxes.push_back(random_box(prng, k % 50 == 0 ? 80 : 3));
    const BoxTree2 tree(boxes);
    for (int round = 0; round < 50; ++round) {
      const Box2 query = random_box(prng, 20);
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

TEST(BoxTree2, FindsTheNearest) {
  Prng prng(2);
  for (const std::size_t n : {0U, 1U, 8U, 9U, 65U, 1000U, 5000U}) {
    std::vector<Box2> boxes;
    for (std::size_t k = 0; k < n; ++k) boxes.push_back(random_box(prng, k % 50 == 0 ? 80 : 3));
    const BoxTree2 tree(boxes);
    std::size_t visited = 0;
    for (int round = 0; round < 50; ++round) {
      const Point2 p{prng.between(-50, 150), prng.between(-50, 150)};
      const auto offset = [&](std::size_t k) {
        const Point2 of = boxes[k].offset(p);
        return std::hypot(of.x, of.y);
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
          [&] { return found * (1 + 0x1p-50); });
      ASSERT_EQ(found, expected);
    }
    EXPECT_LE(visited, 50 * (100 + n / 10));
  }
}

// A square around the point would hold most of them: of a bay, from its middle.
TEST(BoxTree2, TheNearestIsFoundByDistance) {
  constexpr std::size_t kBoxes = 10000;
  std::vector<Box2> boxes;
  for (std::size_t k = 0; k < kBoxes; ++k) {
    const double at = static_cast<double>(k) / kBoxes;  // along an edge from (12, 1) to (1, 12)
    boxes.push_back(box_of({12 - 11 * at, 1 + 11 * at}, {12 - 11 * at, 1 + 11 * at}));
  }
  const BoxTree2 tree(boxes);
  std::size_t visited = 0;
  double found = std::numeric_limits<double>::infinity();
  tree.query_nearest(
      {0, 0},
      [&](std::size_t k) {
        const Point2 of = boxes[k].offset(Point2{0, 0});
        found = std::min(found, std::hypot(of.x, of.y));
        ++visited;
      },
      [&] { return found * (1 + 0x1p-50); });
  EXPECT_NEAR(found, 6.5 * std::sqrt(2.0), 1e-3);
  EXPECT_LT(visited, kBoxes / 20);
}

// As trimming asks: the edges of contours, from points beside them. The limit is asked for once for
// each node that is taken up and each box that is looked at.
TEST(BoxTree2, TheNearestIsFoundAmongAFewHoweverManyThereAre) {
  Prng prng(3);
  for (const std::size_t n : {1000U, 8000U, 64000U}) {
    const auto at = [&](std::size_t k, double radius) {
      const double angle = 2 * 3.141592653589793 * static_cast<double>(k) / static_cast<double>(n);
      return Point2{radius * std::cos(angle), radius * std::sin(angle)};
    };
    std::vector<Box2> edges;
    for (std::size_t k = 0; k < n; ++k) edges.push_back(box_of(at(k, 100), at(k + 1, 100)));
    const BoxTree2 tree(edges);
    std::size_t looked_at = 0;
    constexpr std::size_t kQueries = 500;
    for (std::size_t round = 0; round < kQueries; ++round) {
      // Up to ten edges' lengths away, inside or outside.
      const double away = prng.between(-10, 10) * 600 / static_cast<double>(n);
      const Point2 p = at(static_cast<std::size_t>(prng.below(n)), 100 + away);
      double found = std::numeric_limits<double>::infinity();
      tree.query_nearest(
          p,
          [&](std::size_t k) {
            const Point2 of = edges[k].offset(p);
            found = std::min(found, std::hypot(of.x, of.y));
          },
          [&] {
            ++looked_at;
            return found;
          });
    }
    EXPECT_LT(looked_at, 100 * kQueries) << n;
    RecordProperty("looked_at_" + std::to_string(n), static_cast<int>(looked_at / kQueries));
  }
}

TEST(Box2, MeetsClosedAndOverlapsOpen) {
  const Box2 box{0, 0, 2, 2};
  EXPECT_TRUE(box.meets({2, 2, 3, 3}));
  EXPECT_FALSE(box.overlaps({2, 0, 3, 2}));
  EXPECT_TRUE(box.overlaps({1, 1, 3, 3}));
  EXPECT_FALSE(Box2{}.meets(box));
}

}  // namespace
}  // namespace tetloft::testing
