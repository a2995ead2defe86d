// Numberings against lists of what they number.
#include "slab/numbering.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace tetloft::testing {

using namespace internal;
namespace {

TEST(SlabNumbering, CountsTheLowerSectionThenTheUpperOne) {
  for (const auto& [lower, upper] :
       {std::pair<std::size_t, std::size_t>{0, 0}, {0, 3}, {3, 0}, {1, 1}, {4, 7}}) {
    const SlabVertices numbering(lower, upper);
    EXPECT_EQ(numbering.size(), lower + upper);
    EXPECT_EQ(numbering.lower_size(), lower);
    EXPECT_EQ(numbering.upper_size(), upper);
    std::vector<std::pair<bool, PlaneVertexId>> expected;
    for (std::size_t k = 0; k < lower; ++k) expected.emplace_back(false, PlaneVertexId(k));
    for (std::size_t k = 0; k < upper; ++k) expected.emplace_back(true, PlaneVertexId(k));
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const SlabVertexId id(k);
      const auto& [is_upper, in_section] = expected[k];
      EXPECT_EQ(numbering.is_upper(id), is_upper);
      EXPECT_EQ(numbering.in_section(id), in_section);
      EXPECT_EQ(numbering.in_slab(is_upper, in_section), id);
    }
  }
}

TEST(SlabNumbering, SectionsOfASlabAreThoseBelowAndAboveIt) {
  EXPECT_EQ(lower_section(SlabId(4)), SectionId(4));
  EXPECT_EQ(upper_section(SlabId(4)), SectionId(5));
  EXPECT_EQ(section_of(SlabId(4), false), lower_section(SlabId(4)));
  EXPECT_EQ(section_of(SlabId(4), true), upper_section(SlabId(4)));
}

TEST(StackVertices, GiveEveryVertexOfEverySectionTheNextNumber) {
  const std::vector<std::size_t> counts{3, 0, 5, 1, 0};
  StackVertices vertices;
  EXPECT_EQ(vertices.size(), 0U);
  for (const std::size_t n : counts) vertices.add_section(n);
  std::size_t next = 0;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    for (std::size_t v = 0; v < counts[s]; ++v) {
      EXPECT_EQ(vertices.of(SectionId(s), PlaneVertexId(v)), VertexId(next++));
    }
  }
  EXPECT_EQ(vertices.size(), next);
}

}  // namespace
}  // namespace tetloft::testing
