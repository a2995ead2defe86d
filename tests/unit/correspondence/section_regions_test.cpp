// The trees of regions' edges: made when they are asked for, and again after they were given up.
#include "correspondence/section_regions.hpp"

#include <gtest/gtest.h>

#include <tetloft/nesting.hpp>

#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(SectionRegions, MeasureTheSameAfterTheirEdgesWereForgotten) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1), box(9, 0, 10, 1)}, {box(3, 0, 4, 1)}});
  StackSections sections;
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  for (const SectionId s : nestings.ids()) {
    sections.push_back(SectionRegions(stack.sections[s], nestings[s]));
  }
  const SectionRegions& below = sections[SectionId(0)];
  const SectionRegions& above = sections[SectionId(1)];
  for (int time = 0; time < 3; ++time) {
    EXPECT_EQ(gaps_apart(below, RegionId(0), above, RegionId(0), 8), 2.0);
    EXPECT_EQ(gaps_apart(below, RegionId(1), above, RegionId(0), 8), 5.0);
    if (time == 0) below.forget_edges();
    if (time == 1) forget_edges(sections);
  }
}

}  // namespace
}  // namespace tetloft::testing
