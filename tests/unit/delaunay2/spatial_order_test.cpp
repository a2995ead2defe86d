#include "delaunay2/spatial_order.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "planar_sets.hpp"

namespace tetloft::internal::delaunay2_detail {
namespace {

TEST(InsertionOrder, IsAPermutation) {
  Prng prng(1);
  for (const test::Points& points :
       {test::uniform(1000, prng), test::Points(10, Point2{1, 1}), test::Points{},
        test::scattered_exponents(100, -1073, 1024, prng)}) {
    std::vector<std::uint32_t> order = insertion_order(points);
    std::sort(order.begin(), order.end());
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(order, all);
  }
}

TEST(InsertionOrder, PutsTheLowestOfEqualPointsFirst) {
  Prng prng(2);
  test::Points points;
  for (int i = 0; i < 500; ++i) {
    points.push_back({prng.chance(0.5) ? 0.0 : -0.0, double(prng.below(20))});
  }
  std::map<double, std::uint32_t> last;
  for (const std::uint32_t i : insertion_order(points)) {
    const auto [at, is_first] = last.emplace(points[i].y, i);
    EXPECT_TRUE(is_first || at->second < i);
    at->second = i;
  }
}

TEST(InsertionOrder, DoesNotDependOnTheOrderOfPointsInDifferentCells) {
  Prng prng(3);
  test::Points points = test::lattice(20, 20);
  const auto in_order = [&] {
    test::Points result;
    for (const std::uint32_t i : insertion_order(points)) result.push_back(points[i]);
    return result;
  };
  const test::Points before = in_order();
  prng.shuffle(points);
  EXPECT_EQ(in_order(), before);
}

TEST(InsertionOrder, KeepsNeighboursTogether) {
  Prng prng(4);
  const test::Points points = test::uniform(10000, prng);
  const std::vector<std::uint32_t> order = insertion_order(points);
  double path = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point2& a = points[order[i - 1]];
    const Point2& b = points[order[i]];
    path += std::abs(a.x - b.x) + std::abs(a.y - b.y);
  }
  // A Hilbert tour of n uniform points is about √n long; a random one is n · 2/3.
  EXPECT_LT(path, 400);
}

}  // namespace
}  // namespace tetloft::internal::delaunay2_detail
