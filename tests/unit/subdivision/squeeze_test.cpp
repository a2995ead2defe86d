// Room in tets that are about as thin as the spacing of doubles.
#include "subdivision/squeeze.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tetloft/predicates.hpp>

#include "core/prng.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Tet = std::array<NodeId, 4>;

double& of_axis(Point3& p, Axis axis) {
  return axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z;
}

bool all_positive(const IdVector<NodeId, Point3>& points, const std::vector<Tet>& tets) {
  return std::all_of(tets.begin(), tets.end(), [&](const Tet& t) {
    return orient3d(points[t[0]], points[t[1]], points[t[2]], points[t[3]]) == Sign::positive;
  });
}

Tet tet(std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
  return {NodeId(a), NodeId(b), NodeId(c), NodeId(d)};
}

// Two halves of a tet between two edges whose directions differ by rounding alone, split at
// vertex 4, which lies near the middle of edge 0–1 and a little up.
struct ThinTet {
  IdVector<NodeId, Point3> points;
  std::vector<Tet> halves{tet(4, 1, 2, 3), tet(0, 4, 2, 3)};
};

ThinTet thin_tet(Prng& prng, double z) {
  const double dx = prng.between(0.5, 3), dy = prng.between(0.5, 3);
  const Point3 a{prng.between(-8, 8), prng.between(-8, 8), z};
  const Point3 b{a.x + dx, a.y + dy, z};
  const Point3 c{prng.between(-8, 8), prng.between(-8, 8), z + 1};
  const Point3 d{c.x + dx / 3 * 4, c.y + dy / 3 * 4, z + 1};
  ThinTet result;
  result.points = IdVector<NodeId, Point3>({a, b, c, d});
  const double f = prng.between(0.1, 0.5);
  result.points.push_back({0.5 * (1 - f) * (a.x + b.x) + 0.5 * f * (c.x + d.x),
                           0.5 * (1 - f) * (a.y + b.y) + 0.5 * f * (c.y + d.y), z + f});
  if (orient3d(a, b, c, d) != Sign::positive)
    std::swap(result.points[NodeId(2)], result.points[NodeId(3)]);
  return result;
}

TEST(PositiveRange, HoldsExactlyTheDoublesThatLeaveAllTetsPositive) {
  Prng prng(1);
  int empty = 0, bounded = 0;
  for (int trial = 0; trial < 200; ++trial) {
    ThinTet thin = thin_tet(prng, trial % 2 == 0 ? 0 : 4);
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      // 400 doubles, counted one by one.
      double value = of_axis(thin.points[NodeId(4)], axis);
      const double middle = value;
      for (int k = 0; k < 200; ++k) value = std::nextafter(value, -HUGE_VAL);
      const double from = value;
      std::vector<double> good;
      for (int k = 0; k <= 400; ++k) {
        of_axis(thin.points[NodeId(4)], axis) = value;
        if (all_positive(thin.points, thin.halves)) good.push_back(value);
        if (k < 400) value = std::nextafter(value, HUGE_VAL);
      }
      of_axis(thin.points[NodeId(4)], axis) = middle;
      const auto range = positive_range(thin.points, thin.halves, NodeId(4), axis, {from, value});
      ASSERT_EQ(range.has_value(), !good.empty()) << trial;
      empty += good.empty() ? 1 : 0;
      if (!range) continue;
      EXPECT_EQ(range->first, good.front()) << trial;
      EXPECT_EQ(range->last, good.back()) << trial;
      bounded += good.size() < 401 ? 1 : 0;
    }
  }
  EXPECT_GT(empty, 10);
  EXPECT_GT(bounded, 10);
}

TEST(PositiveRange, CrossesZeroAndSpansAllMagnitudes) {
  IdVector<NodeId, Point3> points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}});
  std::vector<Tet> tets{tet(0, 1, 2, 3)};
  if (!all_positive(points, tets)) std::swap(tets[0][0], tets[0][1]);
  const auto above = positive_range(points, tets, NodeId(3), Axis::z, {-1e300, 1e300});
  ASSERT_TRUE(above);
  EXPECT_EQ(above->first, std::nextafter(0.0, 1.0));
  EXPECT_EQ(above->last, 1e300);
  std::swap(tets[0][0], tets[0][1]);
  const auto below = positive_range(points, tets, NodeId(3), Axis::z, {-1e300, 1e300});
  ASSERT_TRUE(below);
  EXPECT_EQ(below->first, -1e300);
  EXPECT_EQ(below->last, std::nextafter(0.0, -1.0));
}

TEST(Squeeze, FindsDoublesInTetsOfAFewUnitsInTheLastPlace) {
  Prng prng(2);
  int thin_ones = 0, placed_anyway = 0, squeezed = 0;
  for (int trial = 0; trial < 500; ++trial) {
    ThinTet thin = thin_tet(prng, 0);
    if (orient3d(thin.points[NodeId(0)], thin.points[NodeId(1)], thin.points[NodeId(2)],
                 thin.points[NodeId(3)]) != Sign::positive) {
      continue;  // flat
    }
    ++thin_ones;
    if (all_positive(thin.points, thin.halves)) ++placed_anyway;
    const Point3 before = thin.points[NodeId(4)];
    if (squeeze(thin.points, thin.halves, NodeId(4), {1e-300, 0.999}, 0.01)) {
      ++squeezed;
      EXPECT_TRUE(all_positive(thin.points, thin.halves));
      EXPECT_LT(std::abs(thin.points[NodeId(4)].x - before.x) +
                    std::abs(thin.points[NodeId(4)].y - before.y),
                0.1);
      EXPECT_GT(thin.points[NodeId(4)].z, 0);
    } else {
      EXPECT_EQ(thin.points[NodeId(4)], before);
    }
  }
  EXPECT_GT(thin_ones, 300);
  EXPECT_LT(placed_anyway, thin_ones / 2);
  EXPECT_GT(squeezed, thin_ones * 9 / 10);
}

// Refused before there was squeezing: lifted vertices and cuts found no room.
TEST(Squeeze, MakesRoomBetweenEdgesThatAreParallelButForRounding) {
  for (const char* name :
       {"cases/parallel_edges.cnt", "cases/parallel_cuts.cnt", "cases/two_slivers.cnt"}) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(reconstruct_and_check(sample(name)));
  }
  ReconstructOptions reverse;
  reverse.correspondence.criterion = Criterion::reverse;
  EXPECT_TRUE(reconstruct_and_check(sample("cases/parallel_reverse.cnt"), reverse));
}

}  // namespace
}  // namespace tetloft::testing
