// What a model tells of its voids, from what became of slabs.
#include "reconstruct/void_outcome.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "sections/complement.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// A slab of two plates with a hole each, which are linked, and a solid without anything.
struct Outcome {
  Outcome() {
    const SectionStack stack = stack_of_boxes(
        {{box(0, 0, 20, 20), box(5, 5, 9, 9)}, {box(0, 0, 20, 20), box(6, 6, 10, 10)}});
    for (const SectionId s : stack.sections.ids()) {
      sections.push_back(conform(stack.sections[s], s).value());
      complements.push_back(sections::complement_of(stack.sections[s], nest(stack.sections[s]),
                                                    sections::far_outside(stack))
                                .nesting);
    }
    decided.emplace();
    decided->candidates.resize(1);
    LinkCandidate candidate;
    candidate.link = {SlabId(0), RegionId(1U), RegionId(1U)};
    candidate.fate = LinkFate::made;
    decided->candidates[SlabId(0)].push_back(candidate);
    parts.resize(1);
    parts[0].slab = SlabId(0);
    parts[0].lower = SectionId(0);
    parts[0].upper = SectionId(1);
    parts[0].solid.regions = SlabRegions(1, 1);
  }
  [[nodiscard]] VoidOutcome run() { return void_outcome(sections, decided, complements, parts); }

  IdVector<SectionId, ConformingSection> sections;
  IdVector<SectionId, Nesting> complements;
  std::optional<Correspondence> decided;
  std::vector<Part> parts;
};

// Voids of the slab: exterior and hole below, exterior and hole above.
const SlabVoidId kHoleBelow(1U);
const SlabVoidId kOutsideAbove(2U);
const SlabVoidId kHoleAbove(3U);

TEST(VoidOutcome, TellsOfLinksMade) {
  const VoidOutcome told = Outcome().run();
  ASSERT_EQ(told.links.size(), 1U);
  EXPECT_EQ(told.links[0].fate, LinkFate::made);
  EXPECT_EQ(told.links[0].planes, VoidPlanes::across);
  EXPECT_EQ(told.links[0].lower, ContourId(1U));
  EXPECT_EQ(told.links[0].upper, ContourId(1U));
  EXPECT_TRUE(told.deviations.empty());
}

TEST(VoidOutcome, IsNothingWhereNothingWasDecided) {
  Outcome outcome;
  outcome.decided.reset();
  outcome.parts[0].solid.deviations.push_back({SlabRegionId(0U), 0, 0, 1});
  const VoidOutcome told = outcome.run();
  EXPECT_TRUE(told.links.empty());
  EXPECT_TRUE(told.deviations.empty());
}

TEST(VoidOutcome, TellsOfWhatCouldNotBeOpened) {
  Outcome outcome;
  outcome.parts[0].solid.unrealised.push_back({SlabId(0), RegionId(1U), RegionId(1U)});
  const VoidOutcome told = outcome.run();
  ASSERT_EQ(told.links.size(), 1U);
  EXPECT_EQ(told.links[0].fate, LinkFate::unrealisable);
  EXPECT_EQ(outcome.decided->candidates[SlabId(0)][0].fate, LinkFate::unrealisable);
}

TEST(VoidOutcome, TellsOfWhatCouldNotBeParted) {
  Outcome outcome;
  outcome.parts[0].solid.united_voids = {{kOutsideAbove, kHoleBelow}, {kOutsideAbove, kHoleAbove}};
  const VoidOutcome told = outcome.run();
  ASSERT_EQ(told.links.size(), 3U);
  // The lower one first, whichever way it was found.
  EXPECT_EQ(told.links[1].fate, LinkFate::forced);
  EXPECT_EQ(told.links[1].planes, VoidPlanes::across);
  EXPECT_EQ(told.links[1].lower, ContourId(1U));
  EXPECT_FALSE(told.links[1].upper.valid());
  EXPECT_EQ(told.links[2].fate, LinkFate::forced);
  EXPECT_EQ(told.links[2].planes, VoidPlanes::upper);
  EXPECT_FALSE(told.links[2].lower.valid());
  EXPECT_EQ(told.links[2].upper, ContourId(1U));
}

TEST(VoidOutcome, NamesTheRegionsOfDeviations) {
  Outcome outcome;
  outcome.parts[0].solid.deviations = {{SlabRegionId(0U), -1, 0, 1}, {SlabRegionId(1U), 1, 1, 0}};
  const VoidOutcome told = outcome.run();
  ASSERT_EQ(told.deviations.size(), 2U);
  EXPECT_FALSE(told.deviations[0].upper);
  EXPECT_TRUE(told.deviations[1].upper);
  EXPECT_EQ(told.deviations[1].contour, ContourId(0U));
  EXPECT_EQ(told.deviations[0].least, -1);
  EXPECT_EQ(told.deviations[0].most, 0);
  EXPECT_EQ(told.deviations[0].got, 1);
}

// Ends of the stack are no slabs.
TEST(VoidOutcome, LeavesEndsOut) {
  Outcome outcome;
  outcome.parts[0].upper = SectionId();
  outcome.parts[0].solid.deviations.push_back({SlabRegionId(0U), 0, 0, 1});
  outcome.parts[0].solid.unrealised.push_back({SlabId(0), RegionId(1U), RegionId(1U)});
  const VoidOutcome told = outcome.run();
  EXPECT_TRUE(told.deviations.empty());
  EXPECT_EQ(told.links[0].fate, LinkFate::made);
}

}  // namespace
}  // namespace tetloft::testing
