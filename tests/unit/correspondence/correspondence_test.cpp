#include "correspondence/correspondence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "core/prng.hpp"
#include "support/slabs/cases.hpp"

namespace tetloft::testing {
namespace {

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// The overlap links of a stack's only slab, as pairs of regions.
Pairs overlap_pairs(const SectionStack& stack, double tau) {
  const Section& below = stack.sections[SectionId(0)];
  const Section& above = stack.sections[SectionId(1)];
  Pairs pairs;
  for (const Link& link : overlap_links(SlabId(0), below, nest(below), above, nest(above), tau)) {
    EXPECT_EQ(link.slab, SlabId(0));
    pairs.emplace_back(link.lower.index(), link.upper.index());
  }
  return pairs;
}

TEST(OverlapLinks, ARatioOfExactlyTauDoesNotUnite) {
  // Half of either square is shared.
  const SectionStack half = stack_of_boxes({{box(0, 0, 2, 2)}, {box(1, 0, 3, 2)}});
  EXPECT_EQ(overlap_pairs(half, 0.5), Pairs{});
  EXPECT_EQ(overlap_pairs(half, std::nextafter(0.5, 0.0)), (Pairs{{0, 0}}));
  // The double 1/5 is a little more than a fifth, so this ratio does not exceed it.
  const SectionStack fifth = stack_of_boxes({{box(0, 0, 5, 1)}, {box(4, 0, 9, 1)}});
  EXPECT_EQ(overlap_pairs(fifth, 0.2), Pairs{});
  EXPECT_EQ(overlap_pairs(fifth, std::nextafter(0.2, 0.0)), (Pairs{{0, 0}}));
}

TEST(OverlapLinks, RegionsThatOnlyTouchAreNotUnitedByAnyTau) {
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 1, 1)}, {box(1, 0, 2, 1)}}), 0), Pairs{});
}

TEST(OverlapLinks, WhatLiesInAHoleDoesNotOverlap) {
  EXPECT_EQ(
      overlap_pairs(stack_of_boxes({{box(0, 0, 9, 9), box(2, 2, 7, 7)}, {box(3, 3, 6, 6)}}), 0),
      Pairs{});
}

TEST(OverlapLinks, AWeakLinkBetweenTwoWellConnectedRegionsIsTakenForCoincidence) {
  const std::vector<Contour> above{box(0, 0, 2.5, 4), box(3.5, 0, 9, 4)};
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 4, 4), box(5, 0, 9, 4)}, above}), 0.02),
            (Pairs{{0, 0}, {1, 1}}));
  // Without the other link of the upper region the same weak link counts.
  EXPECT_EQ(overlap_pairs(stack_of_boxes({{box(0, 0, 4, 4)}, above}), 0.02),
            (Pairs{{0, 0}, {0, 1}}));
}

TEST(OverlapLinks, ALinkOfExactlyOneQuarterIsStrong) {
  // Of the weak link's regions the upper one is well connected by a ratio of 1/4 exactly.
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(7, 0, 11, 4)}, {box(0, 0, 2.5, 4), box(3.5, 0, 8, 4)}});
  EXPECT_EQ(overlap_pairs(stack, 0.02), (Pairs{{0, 0}, {1, 1}}));
}

TEST(OverlapLinks, ALinkAboveOneQuarterIsNotOutruledByStrongerOnes) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 4), box(6, 0, 10, 4)}, {box(0, 0, 2.5, 4), box(2.8, 0, 8, 4)}});
  EXPECT_EQ(overlap_pairs(stack, 0.02), (Pairs{{0, 0}, {0, 1}, {1, 1}}));
}

// By triangles: both incident ones in the region, or none (and the edge off the contours).
EdgeKind edge_by_triangles(const ConformingSection& section, VertexId u, VertexId v) {
  std::size_t inside = 0;
  for (std::size_t k = 0; k < section.triangulation.triangles.size(); ++k) {
    const TriangleVertices& t = section.triangulation.triangles[TriangleId(k)];
    const bool on = std::count(t.begin(), t.end(), u) + std::count(t.begin(), t.end(), v) == 2;
    if (on && section.internal[TriangleId(k)] != 0) ++inside;
  }
  return inside == 2 ? EdgeKind::internal : inside == 1 ? EdgeKind::contour : EdgeKind::external;
}

TEST(ReverseLinks, JoinTheRegionsOfTetsWithAnInternalEdgeAndNoContourEdge) {
  std::size_t links = 0;
  for (const NamedSlab& s : generated_slabs(400, 1)) {
    SCOPED_TRACE(s.name);
    const Slab& slab = *s.built->slab;
    std::set<std::pair<RegionId, RegionId>> expected;
    for (std::size_t k = 0; k < slab.mesh().tet_slots(); ++k) {
      std::vector<VertexId> low;
      std::vector<VertexId> high;
      for (const VertexId v : slab.mesh().vertices(TetId(k))) {
        (slab.is_upper(v) ? high : low).push_back(slab.in_section(v));
      }
      if (low.size() != 2) continue;
      const std::set<EdgeKind> kinds{edge_by_triangles(s.built->lower, low[0], low[1]),
                                     edge_by_triangles(s.built->upper, high[0], high[1])};
      if (!kinds.contains(EdgeKind::internal) || kinds.contains(EdgeKind::contour)) continue;
      for (const VertexId v : low) {
        for (const VertexId w : high) {
          expected.emplace(s.built->lower.region[v], s.built->upper.region[w]);
        }
      }
    }
    std::set<std::pair<RegionId, RegionId>> found;
    for (const Link& link : reverse_links(SlabId(7), slab)) {
      EXPECT_EQ(link.slab, SlabId(7));
      EXPECT_TRUE(found.emplace(link.lower, link.upper).second);
    }
    EXPECT_EQ(found, expected);
    links += found.size();
  }
  EXPECT_GT(links, 0U);
}

Result<Reconstruction> reconstruct_labelled(const SectionStack& stack, std::string_view labels) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.labels = labels_from(labels);
  return reconstruct(stack, options);
}

void expect_components(const SectionStack& stack, std::string_view labels, std::size_t count) {
  ReconstructOptions options;
  options.execution.threads = 1;
  options.correspondence.labels = labels_from(labels);
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  EXPECT_EQ(checked->result.model.component_count, count);
}

TEST(Labels, SameLabelReunitesWhatDriftedApart) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(3, 0, 4, 1)}});
  expect_components(stack, "", 2);
  expect_components(stack, "0 0 5\n1 0 5", 1);
}

TEST(Labels, SameLabelIsNotLinkedAgainWhereAnotherSlabUnites) {
  // Far apart in the lower section, joined by the upper one.
  const SectionStack joined =
      stack_of_boxes({{box(0, 0, 1, 1), box(5, 0, 6, 1)}, {box(0, 0, 6, 1)}});
  expect_components(joined, "0 0 1\n0 1 1", 1);
}

TEST(Labels, FewestNewLinksReunite) {
  // Two columns: one link across between them rather than two over the region in the middle.
  const std::vector<Contour> both{box(0, 0, 1, 1), box(5, 0, 6, 1)};
  const std::vector<Contour> middle{box(2.5, 0, 3.5, 1)};
  const SectionStack columns = stack_of_boxes({both, both, middle});
  expect_components(columns, "", 3);
  expect_components(columns, "0 0 1\n0 1 1", 2);
  // Without a section to cross to, the unlabelled region in the middle it is.
  const SectionStack feet = stack_of_boxes({both, middle});
  expect_components(feet, "", 3);
  expect_components(feet, "0 0 1\n0 1 1", 1);
}

TEST(Labels, DifferentLabelsKeepOverlappingRegionsApart) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 2, 2)}, {box(0, 0, 2, 2)}});
  expect_components(stack, "", 1);
  expect_components(stack, "0 0 1\n1 0 2", 2);
}

TEST(Labels, DifferentLabelsPartAChainOfUnlabelledRegionsAtItsWeakestLink) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 4, 2)}, {box(0, 0, 4, 2)}, {box(3, 0, 7, 2)}});
  ReconstructOptions options;
  options.correspondence.labels = labels_from("0 0 1\n2 0 2");
  const auto checked = reconstruct_and_check(stack, options);
  ASSERT_TRUE(checked);
  const ContourPartition& partition = checked->result.partition;
  EXPECT_EQ(partition[SectionId(0)], partition[SectionId(1)]);
  EXPECT_NE(partition[SectionId(1)], partition[SectionId(2)]);
}

TEST(Labels, ThatContradictEachOtherInARegionAreRefused) {
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 9, 9), box(2, 2, 7, 7)}});
  const Result<Reconstruction> result = reconstruct_labelled(stack, "1 0 4\n1 1 5");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
  EXPECT_EQ(result.error().where.section, 1U);
  EXPECT_EQ(result.error().where.contour, 1U);
  EXPECT_TRUE(reconstruct_labelled(stack, "1 0 4\n1 1 4").ok());
}

TEST(Labels, OfContoursThatDoNotExistAreRefused) {
  const SectionStack stack = stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  for (const auto& [labels, section, contour] :
       {std::tuple("0 1 7", 0U, 1U), std::tuple("2 0 7", 2U, 0U)}) {
    const Result<Reconstruction> result = reconstruct_labelled(stack, labels);
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().code, ErrorCode::invalid_input);
    EXPECT_EQ(result.error().where.section, section);
    EXPECT_EQ(result.error().where.contour, contour);
  }
}

TEST(Labels, ThatCannotBeRealisedAreRefusedNamingContours) {
  // Two regions of one label with all that lies between them of another.
  const SectionStack stack =
      stack_of_boxes({{box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}, {box(0, 0, 1, 1)}});
  const Result<Reconstruction> result = reconstruct_labelled(stack, "0 0 1\n1 0 2\n2 0 1");
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::unrepresentable);
  EXPECT_NE(result.error().message.find("section 0 contour 0"), std::string::npos);
  EXPECT_NE(result.error().message.find("section 2 contour 0"), std::string::npos);
  EXPECT_EQ(result.error().where.section, 2U);
}

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
  IdVector<SectionId, Nesting> nestings;
  for (const Section& section : stack.sections) nestings.push_back(nest(section));
  IdVector<SlabId, std::vector<Link>> candidates;
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    const SectionId below(k);
    const SectionId above(k + 1);
    candidates.push_back(overlap_links(SlabId(k), stack.sections[below], nestings[below],
                                       stack.sections[above], nestings[above], kDefaultOverlap));
  }
  return decide_correspondence(stack, nestings, candidates, labels);
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
