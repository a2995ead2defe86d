#include "support/stacks/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace tetloft {
namespace {

using tetloft::testing::all_kinds;
using tetloft::testing::generate;
using tetloft::testing::GeneratedStack;
using tetloft::testing::kind_named;
using tetloft::testing::name_of;
using tetloft::testing::StackKind;

constexpr std::uint64_t kSeeds = 30;

// Every coordinate of a stack, for comparison bit by bit.
std::vector<std::uint64_t> bits(const GeneratedStack& generated) {
  std::vector<std::uint64_t> result;
  for (const Section& section : generated.stack.sections) {
    result.push_back(std::bit_cast<std::uint64_t>(section.z));
    for (const Contour& contour : section.contours) {
      result.push_back(contour.vertices.size());
      for (const Point2& p : contour.vertices) {
        result.push_back(std::bit_cast<std::uint64_t>(p.x));
        result.push_back(std::bit_cast<std::uint64_t>(p.y));
      }
    }
  }
  for (const Label& label : generated.correspondence.labels) result.push_back(label.label);
  return result;
}

// How many stacks of a kind have the property.
template <class Property>
std::size_t count(StackKind kind, Property&& property) {
  std::size_t having = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    if (property(generate(kind, seed).stack)) ++having;
  }
  return having;
}

std::uint32_t depth(const SectionStack& stack) {
  std::uint32_t deepest = 0;
  for (const Section& section : stack.sections) {
    for (const std::uint32_t d : nest(section).depth) deepest = std::max(deepest, d);
  }
  return deepest;
}

TEST(Generator, EveryStackIsValidAndSmall) {
  for (const StackKind kind : all_kinds()) {
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      const Result<void> valid = validate(stack);
      EXPECT_TRUE(valid.ok()) << to_string(valid.error());
      EXPECT_GE(stack.sections.size(), 2U);
      EXPECT_LE(stack.sections.size(), 5U);
      EXPECT_GE(stack.vertex_count(), 3U);
      EXPECT_LE(stack.vertex_count(), kind == StackKind::large_contours ? 80000U : 700U);
    }
  }
}

TEST(Generator, SameSeedGivesTheSameBits) {
  for (const StackKind kind : all_kinds()) {
    EXPECT_EQ(bits(generate(kind, 7)), bits(generate(kind, 7))) << name_of(kind);
  }
}

TEST(Generator, SeedsGiveDifferentStacks) {
  for (const StackKind kind : all_kinds()) {
    std::set<std::vector<std::uint64_t>> distinct;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) distinct.insert(bits(generate(kind, seed)));
    EXPECT_GE(distinct.size(), kSeeds - 3) << name_of(kind);
  }
}

TEST(Generator, FewDraftsAreThrownAway) {
  for (const StackKind kind : all_kinds()) {
    int drafts = 0;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) drafts += generate(kind, seed).drafts;
    EXPECT_LE(drafts, 8 * static_cast<int>(kSeeds)) << name_of(kind);
  }
}

TEST(Generator, NamesLeadBackToTheirKinds) {
  for (const StackKind kind : all_kinds()) EXPECT_EQ(kind_named(name_of(kind)), kind);
  EXPECT_FALSE(kind_named("no such kind").has_value());
  EXPECT_GE(all_kinds().size(), 12U);
}

TEST(Generator, LatticesLieOnHalfIntegers) {
  for (const StackKind kind :
       {StackKind::lattice_marching_squares, StackKind::lattice_staircase, StackKind::small_grid}) {
    const std::size_t on_lattice = count(kind, [](const SectionStack& stack) {
      bool all = true;
      for (const Section& section : stack.sections) {
        for (const Contour& contour : section.contours) {
          for (const Point2& p : contour.vertices) {
            all = all && 2 * p.x == std::round(2 * p.x) && 2 * p.y == std::round(2 * p.y);
          }
        }
      }
      return all;
    });
    EXPECT_EQ(on_lattice, kSeeds) << name_of(kind);
  }
}

TEST(Generator, NestingReachesDepthFive) {
  EXPECT_GE(count(StackKind::nesting, [](const SectionStack& s) { return depth(s) == 5; }), 2U);
}

TEST(Generator, HolesAppearAndVanish) {
  const auto changes = [](const SectionStack& stack) {
    std::set<std::size_t> counts;
    for (const Section& section : stack.sections) {
      std::size_t holes = 0;
      for (const std::uint32_t d : nest(section).depth) holes += d == 1 ? 1 : 0;
      counts.insert(holes);
    }
    return counts.size() > 1;
  };
  EXPECT_GE(count(StackKind::holes, changes), kSeeds / 2);
}

// Every void but the exterior is a hole, of depth 1 or 3.
TEST(Generator, KindsWithVoidsHaveHolesAndSomeEndThere) {
  for (const StackKind kind : tetloft::testing::kinds_with_voids()) {
    EXPECT_GE(count(kind, [](const SectionStack& stack) { return depth(stack) >= 1; }), kSeeds - 5)
        << name_of(kind);
  }
  EXPECT_GE(count(StackKind::hole_islands, [](const SectionStack& s) { return depth(s) == 2; }),
            kSeeds / 2);
}

TEST(Generator, TriangularHolesHaveThreeVertices) {
  std::size_t in_one = 0;
  std::size_t in_both = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    std::size_t sections = 0;
    for (const Section& section : generate(StackKind::triangular_holes, seed).stack.sections) {
      const Nesting nesting = nest(section);
      bool triangle = false;
      for (std::size_t c = 0; c < section.contours.size(); ++c) {
        triangle = triangle || (nesting.depth[ContourId(c)] == 1 &&
                                section.contours[ContourId(c)].vertices.size() == 3);
      }
      sections += triangle ? 1 : 0;
    }
    in_one += sections == 1 ? 1 : 0;
    in_both += sections > 1 ? 1 : 0;
  }
  EXPECT_GE(in_one, 5U);
  EXPECT_GE(in_both, 5U);
}

TEST(Generator, EmptySectionsAreEmptySomewhereOnly) {
  EXPECT_EQ(count(StackKind::empty_sections,
                  [](const SectionStack& stack) {
                    return stack.contour_count() > 0 &&
                           std::any_of(stack.sections.begin(), stack.sections.end(),
                                       [](const Section& s) { return s.contours.empty(); });
                  }),
            kSeeds);
}

TEST(Generator, GapsSpanTwelveDecades) {
  double smallest = 1;
  double largest = 1;
  for (std::uint64_t seed = 0; seed < 2 * kSeeds; ++seed) {
    const SectionStack stack = generate(StackKind::extreme_gaps, seed).stack;
    for (std::size_t i = 0; i + 1 < stack.sections.size(); ++i) {
      const double gap = stack.sections[SectionId(i + 1)].z - stack.sections[SectionId(i)].z;
      smallest = std::min(smallest, gap);
      largest = std::max(largest, gap);
    }
  }
  EXPECT_LT(smallest, 1e-5);
  EXPECT_GT(largest, 1e5);
}

// Sections whose regions carry a label have no gap, and one region alone per section only
// if there are two sections: then links between the label's own regions join them.
TEST(Generator, LabelsAreRealisable) {
  std::size_t labelled = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const GeneratedStack generated = generate(StackKind::random_labels, seed);
    std::map<std::uint32_t, std::map<std::size_t, std::set<std::size_t>>> regions;
    std::set<std::pair<std::size_t, std::size_t>> taken;
    for (const Label& label : generated.correspondence.labels) {
      const Section& section = generated.stack.sections[label.section];
      const std::size_t region = nest(section).region[label.contour].index();
      EXPECT_TRUE(taken.insert({label.section.index(), region}).second);
      regions[label.label][label.section.index()].insert(region);
    }
    for (const auto& [label, by_section] : regions) {
      EXPECT_EQ(by_section.rbegin()->first - by_section.begin()->first + 1, by_section.size());
      if (by_section.size() == 1) {
        EXPECT_EQ(by_section.begin()->second.size(), 1U);
      }
    }
    labelled += regions.empty() ? 0U : 1U;
  }
  EXPECT_GE(labelled, kSeeds - 3);
}

}  // namespace
}  // namespace tetloft
