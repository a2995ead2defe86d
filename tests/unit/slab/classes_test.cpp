// Classes: unions of links within one slab.
#include "slab/classes.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(SlabClasses, AreTheUnionsOfLinksNumberedByFirstRegion) {
  const auto c =
      slab_case(stack_of_boxes({{box(0, 0, 1, 1), box(2, 0, 3, 1), box(4, 0, 5, 1)},
                                {box(0, 0, 1, 1), box(2, 0, 3, 1)}}),
                0, {{SlabId(0), RegionId(2), RegionId(0)}, {SlabId(0), RegionId(2), RegionId(1)}});
  const SlabClasses& classes = *c->classes;
  ASSERT_EQ(classes.class_count(), 3U);
  EXPECT_TRUE(classes.is_lone(ClassId(0)));
  EXPECT_TRUE(classes.is_lone(ClassId(1)));
  EXPECT_EQ(classes.regions(ClassId(2)),
            (std::vector<SlabRegionId>{SlabRegionId(2), SlabRegionId(3), SlabRegionId(4)}));
  EXPECT_TRUE(classes.regions().is_upper(SlabRegionId(3)));
  EXPECT_EQ(classes.regions().in_section(SlabRegionId(4)), RegionId(1));
  for (std::size_t v = 0; v < c->slab->vertex_count(); ++v) {
    const Point3 p = c->slab->point(SlabVertexId(v));
    const std::size_t column = p.x < 1.5 ? 0 : p.x < 3.5 ? 1 : 2;
    EXPECT_EQ(classes.region(SlabVertexId(v)), SlabRegionId(p.z == 0 ? column : 3 + column));
  }
}

}  // namespace
}  // namespace tetloft::testing
