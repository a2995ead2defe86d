#include "check/box_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "core/prng.hpp"

namespace tetloft {

using namespace internal;
namespace {

using checking::Box2;
using checking::BoxTree;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Box2> random_boxes(Prng& prng, std::size_t n, bool unbounded) {
  std::vector<Box2> boxes;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 low{static_cast<double>(prng.below(50)), static_cast<double>(prng.below(50))};
    Box2 box{
        low,
        {low.x + static_cast<double>(prng.below(4)), low.y + static_cast<double>(prng.below(4))}};
    if (unbounded && prng.chance(0.1)) box.high.x = kInfinity;
    if (unbounded && prng.chance(0.1)) box.low.y = -kInfinity;
    boxes.push_back(box);
  }
  return boxes;
}

TEST(BoxTree, FindsWhatTouchesAndNothingElse) {
  Prng prng(5);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Box2> boxes = random_boxes(prng, prng.below(200), trial % 2 == 0);
    const BoxTree tree(boxes);
    for (const Box2& query : random_boxes(prng, 20, true)) {
      std::set<std::uint32_t> found;
      tree.meeting(query, [&](std::uint32_t i) {
        EXPECT_TRUE(found.insert(i).second);
        return true;
      });
      std::set<std::uint32_t> expected;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box2& b = boxes[i];
        if (b.low.x <= query.high.x && query.low.x <= b.high.x && b.low.y <= query.high.y &&
            query.low.y <= b.high.y) {
          expected.insert(static_cast<std::uint32_t>(i));
        }
      }
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(BoxTree, StopsWhenTold) {
  Prng prng(6);
  const BoxTree tree(random_boxes(prng, 100, false));
  int visits = 0;
  tree.meeting({{-1, -1}, {99, 99}}, [&](std::uint32_t) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

TEST(BoxTree, FindsTheNearest) {
  Prng prng(7);
  const std::vector<Box2> boxes = random_boxes(prng, 300, false);
  const BoxTree tree(boxes);
  const auto distance_to = [&](const Point2& p) {
    return [&boxes, p](std::uint32_t i) {
      return std::hypot(p.x - boxes[i].low.x, p.y - boxes[i].low.y);
    };
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Point2 p{prng.between(-20, 70), prng.between(-20, 70)};
    double expected = kInfinity;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      expected = std::min(expected, distance_to(p)(i));
    EXPECT_EQ(tree.nearest(p, 0, kInfinity, distance_to(p)), expected);
    EXPECT_EQ(tree.nearest(p, 0, 0.001, distance_to(p)), std::min(expected, 0.001));
    EXPECT_LE(tree.nearest(p, 10, kInfinity, distance_to(p)), std::max(expected, 10.0));
  }
}

TEST(BoxTree, OfNothingFindsNothing) {
  const BoxTree tree;
  tree.meeting({{0, 0}, {1, 1}}, [](std::uint32_t) {
    ADD_FAILURE();
    return true;
  });
  EXPECT_EQ(tree.nearest({0, 0}, 0, 7, [](std::uint32_t) { return 0.0; }), 7);
}

}  // namespace
}  // namespace tetloft
