// The correspondence of a whole stack.
#include "correspondence/correspondence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "core/prng.hpp"
#include "correspondence/overlap_links.hpp"
#include "links_of.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The partition by contours of the original order, renumbered by first contour.
std::vector<std::size_t> renumbered(const ContourPartition& partition,
                                    const std::vector<std::vector<std::size_t>>& place_of) {
  std::vector<std::size_t> result;
  std::map<ComponentId, std::size_t> number;
  for (std::size_t s = 0; s < partition.size(); ++s) {
    for (const std::size_t place : place_of[s]) {
      const ComponentId id = partition[SectionId(s)][ContourId(place)];
      result.push_back(number.try_emplace(id, number.size()).first->second);
    }
  }
  return result;
}

Result<Correspondence> decide(const SectionStack& stack, const std::vector<Label>& labels) {
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const StackSections sections = sections_of(stack, nestings);
  StackCandidates candidates;
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    candidates.push_back(overlap_links(SlabId(k), sections[SectionId(k)],
                                       sections[SectionId(k + 1)], kDefaultOverlap));
  }
  return decide_correspondence(stack, nestings, sections, candidates, {labels, {}});
}

TEST(Correspondence, PartitionDoesNotDependOnTheOrderOfContours) {
  Prng prng(401);
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 402; seed < 405; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const GeneratedStack original = generate(kind, seed);
      SectionStack permuted;
      // place_of[s][c]: where contour c of section s went.
      std::vector<std::vector<std::size_t>> place_of;
      std::vector<std::vector<std::size_t>> unmoved;
      for (const Section& section : original.stack.sections) {
        std::vector<std::size_t> order(section.contours.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        unmoved.push_back(order);
        prng.shuffle(order);
        Section moved;
        moved.z = section.z;
        moved.contours.resize(order.size());
        for (std::size_t c = 0; c < order.size(); ++c) {
          moved.contours[ContourId(order[c])] = section.contours[ContourId(c)];
        }
        permuted.sections.push_back(std::move(moved));
        place_of.push_back(std::move(order));
      }
      std::vector<Label> labels = original.correspondence.labels;
      for (Label& label : labels) {
        label.contour = ContourId(place_of[label.section.index()][label.contour.index()]);
      }
      const auto before = decide(original.stack, original.correspondence.labels);
      const auto after = decide(permuted, labels);
      ASSERT_TRUE(before.ok() && after.ok());
      EXPECT_EQ(renumbered(before->partition, unmoved), renumbered(after->partition, place_of));
      EXPECT_EQ(before->links, after->links);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
