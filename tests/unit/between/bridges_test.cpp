#include "between/bridges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "between/trace_shapes.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

constexpr double kStep = 0.1;
const std::vector<ClassId> kFirst{ClassId(0)};

// Two posts under one, of which the second fades out beside it.
FieldClass post_and_stump() {
  return {{octagon(0, 0, 1), octagon(3, 0, 0.5)},
          {octagon(0, 0, 1)},
          [](double x, double y, std::size_t layer) {
            const double post = to_disc(x, y, 0, 0, 1);
            const double fading = 0.6 - 0.3 * static_cast<double>(layer);
            return std::min(post, to_disc(x, y, 3, 0, fading));
          }};
}

TEST(Bridges, PartsLeftApartAreJoinedOnlyWhereAskedFor) {
  const FieldSlab slab({post_and_stump()}, kStep, 3);
  ClassShapes shapes = slab.shapes();
  const TracedShapes apart = trace_shapes(slab.slab(), shapes);
  EXPECT_EQ(apart.left_apart, kFirst);
  EXPECT_TRUE(apart.inner.sections.empty());
  shapes = slab.shapes();
  const TracedShapes bridged = trace_shapes(slab.slab(), shapes, kFirst);
  EXPECT_TRUE(bridged.left_apart.empty());
  ASSERT_EQ(bridged.inner.sections.size(), 3U);
  // In the first layer, which the second post comes nearest to the first in, from that post on:
  // its stump stays.
  EXPECT_EQ(bridged.inner.sections[0].nesting.outer.size(), 2U);
  EXPECT_EQ(bridged.inner.sections[1].nesting.outer.size(), 1U);
  EXPECT_EQ(bridged.inner.links[0], (std::vector<LayerLink>{{RegionId(0), RegionId(0)},
                                                            {RegionId(1), RegionId(0)},
                                                            {RegionId(1), RegionId(1)}}));
}

TEST(Bridges, ARegionWithNothingAboveItIsTiedToTheLayerBetween) {
  const std::vector<Contour> lower{octagon(0, 0, 1), octagon(2, 0, 0.4)};
  const auto post = [](double x, double y, std::size_t) { return to_disc(x, y, 0, 0, 1); };
  const FieldSlab slab({{lower, {octagon(0, 0, 1)}, post}}, kStep, 1);
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes, kFirst);
  ASSERT_EQ(traced.inner.sections.size(), 1U);
  EXPECT_EQ(traced.inner.links[0],
            (std::vector<LayerLink>{{RegionId(0), RegionId(0)}, {RegionId(1), RegionId(0)}}));
  EXPECT_EQ(traced.inner.links[1], (std::vector<LayerLink>{{RegionId(0), RegionId(0)}}));
  // As wide as a step.
  EXPECT_NEAR(shapes[ClassId(0)].value[1][shapes[ClassId(0)].window.place(13, 0)], -0.5, 1e-12);
}

TEST(Bridges, TwoRegionsSideBySideInAGivenLayerAreNotOne) {
  // Thickened, they share a border of samples; above is only the first.
  const std::vector<Contour> lower{rectangle(-1, -1, 1, 1), rectangle(1.05, -0.5, 1.5, 0.5)};
  const auto post = [](double x, double y, std::size_t) { return to_box(x, y, -1, -1, 0.8, 1); };
  const FieldSlab slab({{lower, {rectangle(-1, -1, 0.8, 1)}, post}}, kStep, 2);
  ClassShapes shapes = slab.shapes();
  EXPECT_EQ(trace_shapes(slab.slab(), shapes).left_apart, kFirst);
  shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes, kFirst);
  ASSERT_EQ(traced.inner.sections.size(), 2U);
  std::vector<RegionId> over_both;
  for (const LayerLink& a : traced.inner.links[0]) {
    for (const LayerLink& b : traced.inner.links[0]) {
      if (a.below < b.below && a.above == b.above) over_both.push_back(a.above);
    }
  }
  EXPECT_EQ(over_both.size(), 1U);
}

TEST(Bridges, OtherClassesAreInTheWay) {
  // A wall from layer to layer, all around the stump.
  const std::vector<Contour> wall{octagon(3, 0, 1.4), octagon(3, 0, 0.8)};
  const auto ring = [](double x, double y, std::size_t) {
    return std::max(to_disc(x, y, 3, 0, 1.4), -to_disc(x, y, 3, 0, 0.8));
  };
  const FieldSlab slab({post_and_stump(), {wall, wall, ring}}, kStep, 3);
  ClassShapes shapes = slab.shapes();
  EXPECT_EQ(trace_shapes(slab.slab(), shapes, kFirst).left_apart, kFirst);
}

}  // namespace
}  // namespace tetloft::testing
