// The voids of a slab, where they lie and what unites them.
#include "completion/slab_voids.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include <tetloft/sections.hpp>

#include "sections/complement.hpp"
#include "unit/completion/void_slab.hpp"

namespace tetloft::testing {
namespace {

const Contour kPlate = box(-10, -10, 10, 10);

Link link(std::size_t lower, std::size_t upper) {
  return {SlabId(0), RegionId(lower), RegionId(upper)};
}

TEST(SlabVoids, LinksMakeClasses) {
  const SectionStack stack = stack_of_boxes({{kPlate, box(-5, -5, -3, 5), box(3, -5, 5, 5)},
                                             {kPlate, box(-6, -4, -4, 4), box(2, -5, 4, 5)}});
  const auto built = slab_case(stack, 0);
  SlabVoids voids(built->lower, built->upper, {link(1, 1)});
  ASSERT_EQ(voids.void_count(), 6U);
  EXPECT_EQ(voids.class_count(), 4U);
  const auto void_of = [&](bool upper, std::size_t v) {
    return voids.numbering().in_slab(upper, RegionId(v));
  };
  EXPECT_EQ(voids.class_of(voids.exterior(false)), VoidClassId(0U));
  EXPECT_EQ(voids.class_of(voids.exterior(true)), VoidClassId(0U));
  EXPECT_FALSE(voids.hole(voids.exterior(true)).valid());
  EXPECT_EQ(voids.hole(void_of(false, 1)), ContourId(1U));
  EXPECT_EQ(voids.hole(void_of(true, 2)), ContourId(2U));
  EXPECT_EQ(voids.class_of(void_of(false, 1)), voids.class_of(void_of(true, 1)));
  EXPECT_NE(voids.class_of(void_of(false, 2)), voids.class_of(void_of(true, 2)));
  voids.unite(void_of(false, 2), void_of(true, 2));
  EXPECT_EQ(voids.class_count(), 3U);
  voids.unite(void_of(true, 2), voids.exterior(false));
  EXPECT_EQ(voids.class_count(), 2U);
  EXPECT_EQ(voids.class_of(void_of(false, 2)), VoidClassId(0U));
}

TEST(SlabVoids, AreNumberedAsRegionsOfTheComplement) {
  std::size_t holes = 0;
  for (const StackKind kind : kinds_with_voids()) {
    const SectionStack stack = generate(kind, 41).stack;
    for (const SectionId s : stack.sections.ids()) {
      const Section& section = stack.sections[s];
      const ConformingSection conforming = conform(section, s).value();
      const SectionVoids voids = voids_of(conforming);
      const Nesting nesting = nest(section);
      const auto complement =
          sections::complement_of(section, nesting, sections::far_outside(stack));
      ASSERT_EQ(voids.hole.size(), complement.nesting.outer.size());
      for (std::size_t v = 0; v < voids.hole.size(); ++v) {
        EXPECT_EQ(voids.hole[v], complement.hole(RegionId(v)));
      }
      holes += voids.hole.size() - 1;
      EXPECT_EQ(voids.of_contour, sections::voids_of_contours(section, nesting));
    }
  }
  EXPECT_GT(holes, 10U);
}

bool is_inside(const Contour& contour, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const Point2& p = contour.vertices[i];
    const Point2& q = contour.vertices[(i + 1) % contour.vertices.size()];
    if ((p.y > y) == (q.y > y)) continue;
    if (x < p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x)) inside = !inside;
  }
  return inside;
}

TEST(SlabVoids, ExternalTrianglesLieInThem) {
  std::size_t in_holes = 0;
  std::size_t outside = 0;
  for_each_void_slab(3, false, [&](const VoidSlab& s) {
    for (const bool upper : {false, true}) {
      const ConformingSection& section = s.slab().section(upper);
      const Section given = sections::given_section(section);
      for (const TriangleId t : section.internal.ids()) {
        const SlabVoidId in = s.voids.at(upper, t);
        ASSERT_EQ(in.valid(), section.internal[t] == 0);
        if (!in.valid()) continue;
        const auto& v = section.triangulation.triangles[t];
        const Point2& a = section.point(v[0]);
        const Point2& b = section.point(v[1]);
        const Point2& c = section.point(v[2]);
        if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 1e-3) continue;
        ContourId innermost;
        for (const ContourId i : given.contours.ids()) {
          if (!is_inside(given.contours[i], (a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3)) continue;
          if (!innermost.valid() || section.nesting.depth[i] > section.nesting.depth[innermost]) {
            innermost = i;
          }
        }
        EXPECT_EQ(s.voids.hole(in), innermost);
        ++(innermost.valid() ? in_holes : outside);
      }
    }
  });
  EXPECT_GT(in_holes, 100U);
  EXPECT_GT(outside, 10U);
}

}  // namespace
}  // namespace tetloft::testing
