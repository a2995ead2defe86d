#include "delaunay3/spatial_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "support.hpp"

namespace tetloft::test {

using namespace internal;
namespace {

using delaunay3_detail::insertion_order;

void expect_permutation(Points points) {
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  std::vector<std::uint32_t> order = insertion_order(points);
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), points.size());
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(InsertionOrder, IsAPermutation) {
  Prng prng(31);
  expect_permutation({});
  expect_permutation({{1, 2, 3}});
  expect_permutation(uniform(1000, prng));
  expect_permutation(lattice(10, 10, 2));
  const double top = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  expect_permutation({{-top, top, -top}, {top, -top, top}, {0, 0, 0}});
  expect_permutation({{0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, least}});
}

TEST(InsertionOrder, NeighboursInOrderAreNearInSpace) {
  Prng prng(32);
  Points points = uniform(20000, prng);
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  const std::vector<std::uint32_t> order = insertion_order(points);
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point3& a = points[order[i - 1]];
    const Point3& b = points[order[i]];
    sum += std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z);
  }
  // A random order has mean distance 1; neighbours on the curve are a few grid widths
  // 20000^(-1/3) = 0.037 apart.
  EXPECT_LT(sum / static_cast<double>(order.size()), 0.08);
}

// The mean distance, along x and y, of points that follow each other.
double mean_step(const Points& points, const std::vector<std::uint32_t>& order) {
  double sum = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point3& a = points[order[i - 1]];
    const Point3& b = points[order[i]];
    sum += std::abs(a.x - b.x) + std::abs(a.y - b.y);
  }
  return sum / static_cast<double>(order.size());
}

TEST(InsertionOrder, SeparatesPointsThatShareACellOfTheFirstGrid) {
  // A unit square seen from so far that its points are one cell of 2^-20.
  Prng prng(34);
  Points points = uniform(5000, prng);
  for (Point3& p : points) p.z = 0;
  points.push_back({0, 0, 1e9});
  points.push_back({0, 0, 2e9});
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  EXPECT_LT(mean_step(points, insertion_order(points)), 0.1);
}

TEST(InsertionOrder, DoesNotDependOnScaleUpToTheLargestDoubles) {
  Prng prng(33);
  Points points = uniform(500, prng);
  for (Point3& p : points) p = {3 * p.x - 1.5, 3 * p.y - 1.5, 3 * p.z - 1.5};
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  const std::vector<std::uint32_t> expected = insertion_order(points);
  for (const double scale : {0x1p-900, 0x1p1023}) {
    Points scaled = points;
    for (Point3& p : scaled) p = {p.x * scale, p.y * scale, p.z * scale};
    EXPECT_EQ(insertion_order(scaled), expected);
  }
}

TEST(InsertionOrder, VisitsBothOfTwoPlanesTogether) {
  // Equal sections far apart: each point and its twin follow each other within a round.
  Points points = lattice(64, 64, 2);
  for (Point3& p : points) p.z *= 1e6;
  std::sort(points.begin(), points.end(),
            [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
  const std::vector<std::uint32_t> order = insertion_order(points);
  std::size_t changes = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i]].z != points[order[i - 1]].z) ++changes;
  }
  EXPECT_GT(changes, order.size() / 4);
}

}  // namespace
}  // namespace tetloft::test
