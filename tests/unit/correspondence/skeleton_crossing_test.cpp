// Propositions 1 to 3 of Nonato et al. (2000) on generated stacks.
//
// Skeletons that only touch decide nothing: in degenerate positions D is one of several Delaunay
// triangulations, and a tet may or may not be there. So what is tested is that tets have dual
// edges that meet, and that dual edges that cross properly have their tet.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/union_find.hpp"
#include "correspondence/correspondence.hpp"
#include "correspondence/reverse_links.hpp"
#include "links_of.hpp"
#include "support/slabs/cases.hpp"
#include "support/voronoi_crossings.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using oracle::Meeting;
using EdgePair = std::pair<EdgeId, EdgeId>;
using ContourPair = std::pair<ContourId, ContourId>;

// The edges below and above of all reverse tets.
std::set<EdgePair> reverse_tets(const Slab& slab) {
  std::set<EdgePair> result;
  for (std::size_t k = 0; k < slab.tet_count(); ++k) {
    const TetId t(k);
    if (slab.kind(t) != TetKind::ii && slab.kind(t) != TetKind::ie) continue;
    std::vector<PlaneVertexId> low, high;
    for (const SlabVertexId v : slab.vertices(t)) {
      (slab.is_upper(v) ? high : low).push_back(slab.in_section(v));
    }
    result.emplace(slab.lower().find_edge(low[0], low[1]),
                   slab.upper().find_edge(high[0], high[1]));
  }
  return result;
}

// Every element of a is one of b.
template <class T>
bool is_within(const std::set<T>& a, const std::set<T>& b) {
  return std::includes(b.begin(), b.end(), a.begin(), a.end());
}

// Proposition 1: the slab has a reverse tet on an edge below and an edge above iff the Voronoi
// edges dual to them cross in projection.
TEST(SkeletonCrossing, IsWhereReverseTetsAre) {
  std::size_t tets = 0, crossings = 0, touching_tets = 0, touches_without = 0;
  for (const NamedSlab& named : generated_slabs(900, 4)) {
    if (!named.built) continue;
    SCOPED_TRACE(named.name);
    const Slab& slab = *named.built->slab;
    const std::set<EdgePair> of_tets = reverse_tets(slab);
    std::set<EdgePair> proper, all;
    for (const SkeletonCrossing& crossing : skeleton_crossings(slab.lower(), slab.upper())) {
      all.emplace(crossing.below, crossing.above);
      if (crossing.proper) proper.emplace(crossing.below, crossing.above);
    }
    EXPECT_TRUE(is_within(proper, of_tets));
    EXPECT_TRUE(is_within(of_tets, all));
    tets += of_tets.size();
    crossings += proper.size();
    touching_tets += of_tets.size() - proper.size();
    touches_without += all.size() - of_tets.size();
  }
  EXPECT_GT(tets, 1000U);
  EXPECT_GT(crossings, 1000U);
  EXPECT_GT(touching_tets, 0U);  // the degenerate case is among them
  EXPECT_GT(touches_without, 0U);
}

// The same from the vertices alone, in rationals; and that skeleton_crossings() finds all.
TEST(SkeletonCrossing, InRationalsIsWhereReverseTetsAre) {
  std::size_t tets = 0, crossings = 0, touching_tets = 0;
  for (const NamedSlab& named : generated_slabs(900, 2)) {
    if (!named.built) continue;
    const Slab& slab = *named.built->slab;
    // Rationals are slow, most of all of coordinates from 1e-150 to 1e150.
    if (slab.vertex_count() > 40 || named.name.starts_with("scale_offset")) continue;
    SCOPED_TRACE(named.name);
    const std::set<EdgePair> of_tets = reverse_tets(slab);
    std::vector<SkeletonCrossing> expected;
    std::vector<oracle::VoronoiEdge> above;
    for (std::size_t f = 0; f < slab.upper().edges.size(); ++f) {
      above.push_back(oracle::voronoi_edge(slab.upper(), EdgeId(f)));
    }
    for (std::size_t e = 0; e < slab.lower().edges.size(); ++e) {
      const oracle::VoronoiEdge below = oracle::voronoi_edge(slab.lower(), EdgeId(e));
      for (std::size_t f = 0; f < above.size(); ++f) {
        if (!oracle::are_reverse(slab.lower().edges[EdgeId(e)].kind,
                                 slab.upper().edges[EdgeId(f)].kind)) {
          continue;
        }
        const bool has_tet = of_tets.contains({EdgeId(e), EdgeId(f)});
        if (!has_tet && below.is_far_from(above[f])) continue;
        const Meeting meeting = oracle::meeting_of(below, above[f]);
        if (meeting != Meeting::apart) {
          expected.push_back({EdgeId(e), EdgeId(f), meeting == Meeting::cross});
        }
        tets += has_tet ? 1U : 0U;
        crossings += meeting == Meeting::cross ? 1U : 0U;
        touching_tets += has_tet && meeting == Meeting::touch ? 1U : 0U;
        if (has_tet) {
          EXPECT_NE(meeting, Meeting::apart) << "edges " << e << " and " << f;
        }
        if (meeting == Meeting::cross) {
          EXPECT_TRUE(has_tet) << "edges " << e << " and " << f;
        }
      }
    }
    EXPECT_EQ(skeleton_crossings(slab.lower(), slab.upper()), expected);
  }
  EXPECT_GT(tets, 15U);
  EXPECT_GT(crossings, 15U);
  EXPECT_GT(touching_tets, 0U);
}

// Proposition 2, in one slab: two contours of neighbouring sections are well positioned, or there
// is no reverse tet between them.
TEST(WellPositionedContours, AreThoseWithAReverseTet) {
  std::size_t with = 0, without = 0;
  for (const NamedSlab& named : generated_slabs(910, 4)) {
    if (!named.built) continue;
    SCOPED_TRACE(named.name);
    const ConformingSection& below = named.built->lower;
    const ConformingSection& above = named.built->upper;
    std::set<ContourPair> of_tets, proper, all;
    for (const auto& [e, f] : reverse_tets(*named.built->slab)) {
      for (const PlaneVertexId v : {below.edges[e].a, below.edges[e].b}) {
        for (const PlaneVertexId w : {above.edges[f].a, above.edges[f].b}) {
          of_tets.emplace(below.contour[v], above.contour[w]);
        }
      }
    }
    for (const WellPositioned& pair : well_positioned(below, above)) {
      EXPECT_TRUE(all.emplace(pair.below, pair.above).second);
      if (pair.proper) proper.emplace(pair.below, pair.above);
    }
    EXPECT_TRUE(is_within(proper, of_tets));
    EXPECT_TRUE(is_within(of_tets, all));
    with += of_tets.size();
    without += below.nesting.region.size() * above.nesting.region.size() - of_tets.size();
  }
  EXPECT_GT(with, 100U);
  EXPECT_GT(without, 100U);
}

// Contours of a stack united by pairs of contours, besides those of one region.
class Closure {
 public:
  explicit Closure(const std::vector<ConformingSection>& sections)
      : first_(numbering(sections)), sets_(first_.back()) {
    for (std::size_t s = 0; s < sections.size(); ++s) {
      const Nesting& nesting = sections[s].nesting;
      for (std::size_t c = 0; c < nesting.region.size(); ++c) {
        const ContourId outer = nesting.outer[nesting.region[ContourId(c)]];
        sets_.unite(first_[s] + c, first_[s] + outer.index());
      }
    }
  }

  void unite(std::size_t slab, const WellPositioned& pair) {
    sets_.unite(first_[slab] + pair.below.index(), first_[slab + 1] + pair.above.index());
  }

  // Are two contours that are in one set in one component?
  [[nodiscard]] bool is_finer_than(const std::vector<ComponentId>& component) const {
    for (std::size_t c = 0; c < sets_.size(); ++c) {
      if (component[c] != component[sets_.find(c)]) return false;
    }
    return true;
  }
  // Are two contours of one component in one set?
  [[nodiscard]] bool is_coarser_than(const std::vector<ComponentId>& component) const {
    std::vector<std::size_t> first(component.size(), component.size());
    for (std::size_t c = 0; c < sets_.size(); ++c) {
      std::size_t& of_component = first[component[c].index()];
      if (of_component == component.size()) of_component = c;
      if (!sets_.same(of_component, c)) return false;
    }
    return true;
  }

 private:
  static std::vector<std::size_t> numbering(const std::vector<ConformingSection>& sections) {
    std::vector<std::size_t> first{0};
    for (const ConformingSection& s : sections) {
      first.push_back(first.back() + s.nesting.region.size());
    }
    return first;
  }

  std::vector<std::size_t> first_;  // first_[s]: the first contour of section s
  UnionFind sets_;
};

struct Tally {
  std::size_t decided = 0;    // stacks where no pair only touches
  std::size_t several = 0;    // of these: of more than one component
  std::size_t undecided = 0;  // where touching pairs make a difference
};

// Proposition 2, in a stack: the partition is that by well positioned pairs, unless some only
// touch; then it lies between that without and that with these.
void expect_partition_by_positions(const SectionStack& stack, const ContourPartition& partition,
                                   Tally& tally) {
  std::vector<ConformingSection> sections;
  for (std::size_t s = 0; s < stack.sections.size(); ++s) {
    sections.push_back(conform(stack.sections[SectionId(s)], SectionId(s)).value());
  }
  Closure proper(sections), all(sections);
  bool touch = false;
  for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
    for (const WellPositioned& pair : well_positioned(sections[k], sections[k + 1])) {
      if (pair.proper) proper.unite(k, pair);
      all.unite(k, pair);
      touch = touch || !pair.proper;
    }
  }
  std::vector<ComponentId> component;
  for (const auto& of_section : partition) {
    component.insert(component.end(), of_section.begin(), of_section.end());
  }
  EXPECT_TRUE(proper.is_finer_than(component));
  EXPECT_TRUE(all.is_coarser_than(component));
  if (!touch) {
    EXPECT_TRUE(proper.is_coarser_than(component));
    ++tally.decided;
    const bool one = std::all_of(component.begin(), component.end(),
                                 [&](ComponentId c) { return c == component.front(); });
    tally.several += one ? 0U : 1U;
  } else if (!proper.is_coarser_than(component) || !all.is_finer_than(component)) {
    ++tally.undecided;
  }
}

Result<Correspondence> reverse_correspondence(const SectionStack& stack) {
  const IdVector<SectionId, Nesting> nestings = nestings_of(stack);
  const StackSections sections = sections_of(stack, nestings);
  StackCandidates candidates(stack.sections.size() - 1);
  for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
    const auto built = slab_case(stack, k);
    if (!built) continue;
    for (const Link& link : reverse_links(SlabId(k), *built->slab)) {
      candidates[SlabId(k)].push_back({link, Evidence::reverse});
    }
  }
  return decide_correspondence(stack, nestings, sections, candidates, {});
}

TEST(WellPositionedContours, ArePartitionedAsByReverseTets) {
  Tally tally;
  for (const StackKind kind : all_kinds()) {
    // Conforming itself may be refused there.
    if (is_near_coincident(kind)) continue;
    for (std::uint64_t seed = 920; seed < 928; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      expect_partition_by_positions(stack, reverse_correspondence(stack).value().partition, tally);
    }
  }
  EXPECT_GT(tally.decided, 30U);
  EXPECT_GT(tally.several, 10U);
  EXPECT_GT(tally.undecided, 0U);
}

// Proposition 3: what is built on well positioned contours is a manifold.
TEST(WellPositionedContours, GiveManifolds) {
  ReconstructOptions options;
  options.correspondence.criterion = Criterion::reverse;
  options.execution.threads = 1;
  Tally tally;
  std::size_t tets = 0;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind) || kind == StackKind::large_contours) continue;
    for (std::uint64_t seed = 930; seed < 938; ++seed) {
      SCOPED_TRACE(std::string(name_of(kind)) + " seed " + std::to_string(seed));
      const SectionStack stack = generate(kind, seed).stack;
      const Result<Reconstruction> result = reconstruct(stack, options);
      ASSERT_TRUE(result.ok()) << to_string(result.error());
      const Result<CheckReport> report =
          check(result->model, stack, {.correspondence = options.correspondence});
      ASSERT_TRUE(report.ok()) << to_string(report.error());
      EXPECT_EQ(report->guarantees.front().number, 1);
      EXPECT_TRUE(report->guarantees.front().pass);
      tets += result->model.tets.size();
      expect_partition_by_positions(stack, result->partition, tally);
    }
  }
  EXPECT_GT(tets, 10000U);
  EXPECT_GT(tally.decided, 50U);
}

}  // namespace
}  // namespace tetloft::testing
