// Convex filling: copies of a convex contour keep their corners, and nothing beyond the region is
// filled.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/prng.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

Contour convex(Prng& prng, std::size_t corners) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < corners; ++k) angles.push_back(6.28 * prng.unit());
  std::sort(angles.begin(), angles.end());
  Contour contour;
  for (const double a : angles) contour.vertices.push_back({5 * std::cos(a), 3 * std::sin(a)});
  return contour;
}

TEST(ConvexFilling, BetweenCopiesOfAConvexContourAllOfTheTriangulationIsKept) {
  Prng prng(213);
  std::size_t filled = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Contour contour = convex(prng, 4 + prng.below(12));
    const auto c = slab_case(stack_of_boxes({{contour}, {contour}}), 0,
                             {{SlabId(0), RegionId(0), RegionId(0)}});
    const Completed completed = complete(*c, true);
    for (const TetId t : c->slab->tets()) {
      EXPECT_EQ(completed.complex.kept[t], 0xF) << trial;
      EXPECT_EQ(completed.complex.attached[t], 0xF) << trial;
      if (c->slab->kind(t) == TetKind::cc && completed.seed.kept[t] == 0) ++filled;
    }
  }
  EXPECT_GT(filled, 20U);
}

TEST(ConvexFilling, CopiesOfAConvexContourGiveTheirPrism) {
  Prng prng(214);
  for (int trial = 0; trial < 10; ++trial) {
    const Contour contour = convex(prng, 4 + prng.below(12));
    double area = 0;  // twice
    for (std::size_t k = 0; k < contour.vertices.size(); ++k) {
      const Point2& a = contour.vertices[k];
      const Point2& b = contour.vertices[(k + 1) % contour.vertices.size()];
      area += a.x * b.y - b.x * a.y;
    }
    const auto checked = reconstruct_and_check(stack_of_boxes({{contour}, {contour}}));
    ASSERT_TRUE(checked);
    EXPECT_NEAR(checked->report.volume, area / 2, 1e-9);
  }
}

}  // namespace
}  // namespace tetloft::testing
