// The numbering of all regions of a stack, and sets of them that know their label.
#include "correspondence/stack_regions.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/prng.hpp"
#include "correspondence/labelled_sets.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

IdVector<SectionId, Nesting> nestings_of(const std::vector<std::size_t>& regions) {
  IdVector<SectionId, Nesting> result;
  for (const std::size_t n : regions) {
    Nesting nesting;
    nesting.outer.resize(n);
    result.push_back(std::move(nesting));
  }
  return result;
}

TEST(StackRegions, NumberRegionsBySectionAndAreFoundAgain) {
  // Sections without region at both ends, and in a row.
  const std::vector<std::size_t> counts{0, 2, 0, 0, 3, 1, 0};
  const StackRegions regions(nestings_of(counts));
  std::size_t next = 0;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    for (std::size_t r = 0; r < counts[s]; ++r, ++next) {
      const StackRegionId id(next);
      EXPECT_EQ(regions.of(SectionId(s), RegionId(r)), id);
      EXPECT_EQ(regions.locate(id), std::pair(SectionId(s), RegionId(r)));
    }
  }
  EXPECT_EQ(regions.size(), next);
}

TEST(StackRegions, LinksJoinARegionBelowWithOneAbove) {
  const StackRegions regions(nestings_of({2, 3, 1}));
  const Link link{SlabId(1), RegionId(2), RegionId(0)};
  EXPECT_EQ(regions.below(link), StackRegionId(4));
  EXPECT_EQ(regions.above(link), StackRegionId(5));
}

// Sets as lists, united where labels allow it.
TEST(LabelledSets, UniteAsListsOfTheirMembersDo) {
  Prng prng(9);
  std::size_t united = 0;
  std::size_t refused = 0;
  for (int trial = 0; trial < 50; ++trial) {
    constexpr std::size_t kRegions = 12;
    RegionLabels labels(kRegions);
    for (const StackRegionId r : labels.ids()) {
      if (prng.below(3) == 0) labels[r] = static_cast<std::uint32_t>(prng.below(2));
    }
    LabelledSets sets(labels);
    std::vector<std::size_t> group(kRegions);
    for (std::size_t r = 0; r < kRegions; ++r) group[r] = r;
    const auto labels_in = [&](std::size_t g) {
      std::set<std::uint32_t> found;
      for (std::size_t r = 0; r < kRegions; ++r) {
        if (group[r] == g && labels[StackRegionId(r)]) found.insert(*labels[StackRegionId(r)]);
      }
      return found;
    };
    for (int step = 0; step < 10; ++step) {
      const std::size_t a = prng.below(kRegions);
      const std::size_t b = prng.below(kRegions);
      std::set<std::uint32_t> joint = labels_in(group[a]);
      joint.merge(labels_in(group[b]));
      const bool may = joint.size() <= 1;
      ASSERT_EQ(sets.may_unite(StackRegionId(a), StackRegionId(b)), may);
      ++(may ? united : refused);
      if (!may) continue;
      sets.unite(StackRegionId(a), StackRegionId(b));
      const std::size_t from = group[b];
      for (std::size_t& g : group) g = g == from ? group[a] : g;
    }
    for (std::size_t r = 0; r < kRegions; ++r) {
      std::size_t least = 0;
      while (group[least] != group[r]) ++least;
      EXPECT_EQ(sets.find(StackRegionId(r)), StackRegionId(least));
      const std::set<std::uint32_t> own = labels_in(group[r]);
      const std::optional<std::uint32_t> expected =
          own.empty() ? std::nullopt : std::optional(*own.begin());
      EXPECT_EQ(sets.label(StackRegionId(r)), expected);
    }
  }
  EXPECT_GT(united, 100U);
  EXPECT_GT(refused, 20U);
}

}  // namespace
}  // namespace tetloft::testing
