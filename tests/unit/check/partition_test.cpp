// Overlap and labels, in the rule of correspondence.hpp as check recomputes it; the rest of it:
// rule_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include <tetloft/delaunay.hpp>

#include "support/stacks/generate.hpp"
#include "unit/check/rule_stacks.hpp"

namespace tetloft {

using namespace internal;
namespace {

using checking::Link;

using testing::box;
using testing::Classes;
using testing::classes;
using testing::labelled;
using testing::plain;
using testing::stack_of;

TEST(Partition, UnitesOverlappingRegionsOfNeighbouringSections) {
  EXPECT_EQ(classes(stack_of({{box(0, 0, 4, 4)}, {box(1, 1, 5, 5)}})), (Classes{0, 0}));
  EXPECT_EQ(classes(stack_of({{box(0, 0, 4, 4)}, {box(4, 0, 8, 4)}})), (Classes{0, 1}));
  EXPECT_EQ(classes(stack_of({{box(0, 0, 4, 4)}, {}, {box(0, 0, 4, 4)}})), (Classes{0, 1}));
}

TEST(Partition, KeepsTheContoursOfARegionTogether) {
  EXPECT_EQ(classes(stack_of({{box(2, 2, 4, 4), box(0, 0, 6, 6), box(2.5, 2.5, 3.5, 3.5)}})),
            (Classes{0, 0, 1}));
}

TEST(Partition, DoesNotCountAHoleAsOverlap) {
  // A plug over the hole of a frame.
  EXPECT_EQ(classes(stack_of({{box(0, 0, 6, 6), box(2, 2, 4, 4)}, {box(2.5, 2.5, 3.5, 3.5)}})),
            (Classes{0, 0, 1}));
}

TEST(Partition, DoesNotUniteAtEquality) {
  CorrespondenceOptions options = plain();
  options.tau = 0.25;
  EXPECT_EQ(classes(stack_of({{box(0, 0, 4, 4)}, {box(3, 0, 7, 4)}}), options), (Classes{0, 1}));
  options.tau = std::nextafter(0.25, 0.0);
  EXPECT_EQ(classes(stack_of({{box(0, 0, 4, 4)}, {box(3, 0, 7, 4)}}), options), (Classes{0, 0}));
}

TEST(Partition, OutrulesAWeakLinkBetweenWellConnectedRegions) {
  const std::vector<Contour> below{box(0, 0, 4, 4), box(5, 0, 9, 4)};
  EXPECT_EQ(classes(stack_of({below, {box(0, 0, 4.5, 4), box(5, 0, 9, 4)}})),
            (Classes{0, 1, 0, 1}));
  // The left one reaches over to the right one, by an eighth.
  EXPECT_EQ(classes(stack_of({below, {box(0, 0, 5.5, 3), box(6, 0, 9, 4)}})),
            (Classes{0, 1, 0, 1}));
  // Without the region above the right one it has nothing better.
  EXPECT_EQ(classes(stack_of({below, {box(0, 0, 5.5, 3)}})), (Classes{0, 0, 0}));
}

TEST(Partition, CountsARatioOfAHalfAsStrong) {
  const std::vector<Contour> below{box(0, 0, 4, 4), box(5, 0, 9, 4)};
  // The right pair overlaps by exactly half of either.
  EXPECT_EQ(classes(stack_of({below, {box(0, 0, 5.5, 1.5), box(7, 0, 11, 4)}})),
            (Classes{0, 1, 0, 1}));
}

TEST(Partition, RefusesLinksBetweenDifferentLabels) {
  const SectionStack stack = stack_of({{box(0, 0, 4, 4)}, {box(0, 0, 4, 4)}, {box(0, 0, 4, 4)}});
  EXPECT_EQ(classes(stack, labelled({{0, 0, 1}, {2, 0, 2}})), (Classes{0, 0, 1}));
}

TEST(Partition, TakesLinksByDecreasingEvidence) {
  // The middle one may join one of the two labels only: the one it overlaps more.
  const SectionStack stack = stack_of({{box(0, 0, 4, 4)}, {box(1, 0, 5, 4)}, {box(3, 0, 7, 4)}});
  EXPECT_EQ(classes(stack, labelled({{0, 0, 1}, {2, 0, 2}})), (Classes{0, 0, 1}));
  const SectionStack mirrored = stack_of({{box(3, 0, 7, 4)}, {box(1, 0, 5, 4)}, {box(0, 0, 4, 4)}});
  EXPECT_EQ(classes(mirrored, labelled({{0, 0, 1}, {2, 0, 2}})), (Classes{0, 1, 1}));
}

TEST(Partition, ConnectsALabelByTheNearestLink) {
  // Two regions of label 5 over one another's side; nothing overlaps.
  const SectionStack stack =
      stack_of({{box(0, 0, 1, 1)}, {box(3, 0, 4, 1), box(6, 0, 7, 1)}, {box(9, 0, 10, 1)}});
  EXPECT_EQ(classes(stack, labelled({{0, 0, 5}, {1, 1, 5}})), (Classes{0, 1, 0, 2}));
  // Over the nearer of two unlabelled ones: 2 + 5 by the first, 5 + 2 by the second is the
  // same sum, and the lower region decides.
  EXPECT_EQ(classes(stack, labelled({{0, 0, 5}, {2, 0, 5}})), (Classes{0, 0, 1, 0}));
  const SectionStack nearer =
      stack_of({{box(0, 0, 1, 1)}, {box(3, 8, 4, 9), box(6, 0, 7, 1)}, {box(9, 0, 10, 1)}});
  EXPECT_EQ(classes(nearer, labelled({{0, 0, 5}, {2, 0, 5}})), (Classes{0, 1, 0, 0}));
}

TEST(Partition, GoesThroughExistingSetsWithoutNewLinks) {
  // A pillar nearby saves the way over two new regions: two links, not four.
  const std::vector<Contour> pillar{box(20, 0, 21, 1)};
  const auto with = [&](const Contour& c) {
    std::vector<Contour> layer{c};
    layer.push_back(pillar[0]);
    return layer;
  };
  const SectionStack stack =
      stack_of({with(box(0, 0, 1, 1)), with(box(3, 0, 4, 1)), with(box(6, 0, 7, 1)),
                with(box(9, 0, 10, 1)), with(box(12, 0, 13, 1))});
  EXPECT_EQ(classes(stack, labelled({{0, 0, 5}, {4, 0, 5}})),
            (Classes{0, 0, 1, 0, 2, 0, 3, 0, 0, 0}));
}

TEST(Partition, TellsWhichLabelCannotBeRealised) {
  const SectionStack stack = stack_of({{box(0, 0, 1, 1), box(3, 0, 4, 1)}, {box(0, 0, 4, 1)}});
  const auto expected =
      checking::expected_partition(stack, stack, labelled({{0, 0, 8}, {0, 1, 8}, {1, 0, 9}}));
  ASSERT_TRUE(expected.ok());
  EXPECT_EQ(expected->unrealised, std::optional<std::uint32_t>(8));
}

// Reverse links from the tets of the 3D Delaunay triangulation of each slab.
std::set<std::pair<std::size_t, std::size_t>> links_from_tets(const SectionStack& stack,
                                                              const checking::Regions& regions) {
  std::set<std::pair<std::size_t, std::size_t>> links;
  std::vector<ConformingSection> sections;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    auto section = conform(stack.sections[SectionId(s)], SectionId(s));
    if (!section.ok()) return {};
    sections.push_back(*std::move(section));
  }
  for (std::size_t s = 0; s + 1 < sections.size(); ++s) {
    std::vector<Point3> points;
    for (const std::size_t side : {s, s + 1}) {
      for (std::size_t v = 0; v < sections[side].vertex_count(); ++v) {
        points.push_back(sections[side].point3(PlaneVertexId(v)));
      }
    }
    const std::size_t lower_count = sections[s].vertex_count();
    const auto d = delaunay3(points);
    if (!d.ok()) continue;
    for (std::size_t t = 0; t < d->mesh.tet_slots(); ++t) {
      std::vector<PlaneVertexId> lower;
      std::vector<PlaneVertexId> upper;
      for (const VertexId v : d->mesh.vertices(TetId(t))) {
        if (v.index() < lower_count) {
          lower.emplace_back(v.value());
        } else {
          upper.emplace_back(v.index() - lower_count);
        }
      }
      if (lower.size() != 2) continue;
      const EdgeId e = sections[s].find_edge(lower[0], lower[1]);
      const EdgeId f = sections[s + 1].find_edge(upper[0], upper[1]);
      EXPECT_TRUE(e.valid() && f.valid());
      const EdgeKind below = sections[s].edges[e].kind;
      const EdgeKind above = sections[s + 1].edges[f].kind;
      if (below == EdgeKind::contour || above == EdgeKind::contour ||
          (below == EdgeKind::external && above == EdgeKind::external)) {
        continue;
      }
      for (const PlaneVertexId v : lower) {
        for (const PlaneVertexId w : upper) {
          links.emplace(regions.of(s, sections[s].contour[v].index()),
                        regions.of(s + 1, sections[s + 1].contour[w].index()));
        }
      }
    }
  }
  return links;
}

TEST(ReverseLinks, AreThoseOfTheDelaunayTets) {
  std::size_t found = 0;
  for (const testing::StackKind kind : testing::all_kinds()) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      const SectionStack stack = testing::generate(kind, seed).stack;
      const checking::Regions regions = checking::number_regions(stack);
      const auto links = checking::reverse_links(stack, regions);
      if (!links.ok()) continue;
      std::set<std::pair<std::size_t, std::size_t>> pairs;
      for (const Link& link : *links) pairs.emplace(link.lower, link.upper);
      EXPECT_EQ(pairs, links_from_tets(stack, regions)) << name_of(kind) << ", seed " << seed;
      found += pairs.size();
    }
  }
  EXPECT_GT(found, 300U);
}

}  // namespace
}  // namespace tetloft
