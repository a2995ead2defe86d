// Gluing as parts arrive: the model does not depend on when they do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "property/same_model.hpp"
#include "reconstruct/assembly.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

class AssemblyOfEnds : public ::testing::Test {
 protected:
  AssemblyOfEnds() {
    const SectionStack stack =
        stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 3, 2), box(5, 0, 6, 2)}, {box(1, 0, 2, 2)}});
    for (std::size_t s = 0; s < stack.sections.size(); ++s) {
      const SectionId id(s);
      sections_.push_back(conform(stack.sections[id], id).value());
      const std::size_t regions = sections_[id].nesting.outer.size();
      correspondence_.component.push_back(IdVector<RegionId, ComponentId>(regions, ComponentId(s)));
    }
  }

  // The place-th part: a prism on each section.
  [[nodiscard]] Part part(std::size_t place) const {
    const SectionId s(place);
    return {SlabId(place), SectionId(), s, build_end(sections_[s], sections_[s].z - 0.25)};
  }

  IdVector<SectionId, ConformingSection> sections_;
  Correspondence correspondence_;
};

TEST_F(AssemblyOfEnds, TheOrderOfArrivalPlaysNoPart) {
  Assembly in_order(sections_, correspondence_);
  for (std::size_t k = 0; k < 3; ++k) in_order.add(k, part(k));
  const Model expected = in_order.take();
  EXPECT_EQ(expected.component_count, 3U);
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    Assembly assembly(sections_, correspondence_);
    for (const std::size_t k : order) assembly.add(k, part(k));
    EXPECT_EQ(assembly.tally().rules, in_order.tally().rules);
    EXPECT_TRUE(same_bits(assembly.take(), expected));
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_F(AssemblyOfEnds, AModelThatLacksAPartIsNotHandedOut) {
  Assembly assembly(sections_, correspondence_);
  assembly.add(0, part(0));
  assembly.add(2, part(2));
  EXPECT_ANY_THROW((void)assembly.take());
  assembly.add(1, part(1));
  EXPECT_EQ(assembly.take().slab[TetId(0)], SlabId(0));
}

}  // namespace
}  // namespace tetloft::testing
