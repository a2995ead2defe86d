// From fields to sections: what must hold of any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "between/trace_shapes.hpp"
#include "core/prng.hpp"
#include "unit/between/field_slab.hpp"

namespace tetloft::testing {

using namespace internal;
using namespace internal::between;
namespace {

// A few waves: smooth, the same on every machine.
Field random_waves(Prng& random, double level) {
  struct Wave {
    double x, y, radius, weight;
  };
  std::vector<Wave> waves;
  for (int n = 0; n < 14; ++n) {
    waves.push_back({random.between(-4, 4), random.between(-4, 4), random.between(0.5, 1.6),
                     random.between(-1, 1.4)});
  }
  return [waves, level](double x, double y, std::size_t) {
    double sum = level;
    for (const Wave& w : waves) {
      const double d = ((x - w.x) * (x - w.x) + (y - w.y) * (y - w.y)) / (w.radius * w.radius);
      sum -= w.weight / (1 + d * d);
    }
    return std::max(sum, to_box(x, y, -5, -5, 5, 5));
  };
}

SectionStack stack_of(const SlabShape& slab, const InnerSections& inner) {
  SectionStack stack;
  stack.sections.push_back(slab.lower);
  for (const InnerSection& section : inner.sections) stack.sections.push_back(section.section);
  stack.sections.push_back(slab.upper);
  return stack;
}

TEST(TracedFields, AConeBetweenTwoOctagonsHasRoundSections) {
  const FieldSlab slab({{{octagon(0, 0, 2)},
                         {octagon(0, 0, 1)},
                         [](double x, double y, std::size_t layer) {
                           return to_disc(x, y, 0, 0, 2 - static_cast<double>(layer) / 4);
                         }}},
                       0.1, 3);
  ClassShapes shapes = slab.shapes();
  const TracedShapes traced = trace_shapes(slab.slab(), shapes);
  ASSERT_EQ(traced.inner.sections.size(), 3U);
  ASSERT_EQ(traced.inner.links.size(), 4U);
  const double pi = 3.14159265;
  for (std::size_t k = 0; k < 3; ++k) {
    const InnerSection& section = traced.inner.sections[k];
    ASSERT_EQ(section.section.contours.size(), 1U);
    EXPECT_EQ(section.section.z, static_cast<double>(k + 1) / 4);
    const double r = 2 - static_cast<double>(k + 1) / 4;
    EXPECT_NEAR(twice_area(section.section.contours[ContourId(0)]) / 2 / (pi * r * r), 1, 2e-3);
    EXPECT_LT(section.section.contours[ContourId(0)].vertices.size(), 40U);
  }
  for (const auto& links : traced.inner.links) {
    EXPECT_EQ(links, std::vector<LayerLink>({{RegionId(0), RegionId(0)}}));
  }
}

TEST(TracedFields, RandomFieldsOfSeveralClassesGiveValidSections) {
  std::size_t traced_slabs = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Prng random(seed);
    std::vector<FieldClass> classes;
    for (int c = 0; c < 3; ++c) {
      const double x = -3 + 3 * c;
      classes.push_back({{octagon(x, 0, 1.2)}, {octagon(x, 0.3, 1.2)}, random_waves(random, 0.3)});
    }
    const FieldSlab slab(classes, 0.17, 1 + seed % 3);
    ClassShapes shapes = slab.shapes();
    const TracedShapes traced = trace_shapes(slab.slab(), shapes);
    if (traced.inner.sections.empty()) {
      EXPECT_FALSE(traced.left_apart.empty()) << seed;
      continue;
    }
    ++traced_slabs;
    const auto valid = validate(stack_of(slab.slab(), traced.inner));
    EXPECT_TRUE(valid.ok()) << seed << ": " << valid.error().message;
  }
  EXPECT_GT(traced_slabs, 20U);
}

}  // namespace
}  // namespace tetloft::testing
