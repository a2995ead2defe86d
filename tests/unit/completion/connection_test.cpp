// Classes are connected wherever D has edges for it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "core/prng.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// The regions of a class fall into so many sets if those joined by an edge of D hang together.
std::size_t sets_by_edges(const SlabCase& c, ClassId id) {
  std::set<std::set<SlabRegionId>> joined;
  for (const TetId t : c.slab->tets()) {
    std::set<SlabRegionId> own;
    for (int i = 0; i < 4; ++i) {
      const SlabVertexId v = c.slab->vertex(t, i);
      if (c.classes->of(v) == id) own.insert(c.classes->region(v));
    }
    if (own.size() > 1) joined.insert(own);
  }
  std::set<SlabRegionId> left(c.classes->regions(id).begin(), c.classes->regions(id).end());
  std::size_t sets = 0;
  while (!left.empty()) {
    ++sets;
    std::set<SlabRegionId> reached{*left.begin()};
    for (std::size_t before = 0; before != reached.size();) {
      before = reached.size();
      for (const std::set<SlabRegionId>& tet : joined) {
        const bool meets = std::any_of(tet.begin(), tet.end(),
                                       [&](SlabRegionId r) { return reached.contains(r); });
        if (meets) reached.insert(tet.begin(), tet.end());
      }
    }
    for (const SlabRegionId r : reached) left.erase(r);
  }
  return sets;
}

TEST(Connection, LeavesExactlyThoseClassesApartThatNoEdgesOfTheTriangulationJoin) {
  Prng prng(212);
  std::size_t apart = 0;
  std::size_t connected = 0;
  RuleCounts rules{};
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind)) continue;
    SCOPED_TRACE(name_of(kind));
    for (std::uint64_t seed = 212; seed < 215; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      const std::size_t lower = nest(stack.sections[SectionId(0)]).outer.size();
      const std::size_t upper = nest(stack.sections[SectionId(1)]).outer.size();
      if (lower == 0 || upper == 0) continue;
      // Any links at all, whether the regions overlap or not.
      std::set<Link> links;
      for (std::size_t k = 0; k < 1 + std::min(lower, upper) / 2; ++k) {
        links.insert({SlabId(0), RegionId(prng.below(lower)), RegionId(prng.below(upper))});
      }
      const auto c = slab_case(stack, 0, {links.begin(), links.end()});
      const Completed completed = complete(*c, false);
      for (std::size_t r = 0; r < rules.size(); ++r) rules.at(r) += completed.rules.at(r);
      std::set<ClassId> left;
      for (const LeftApart& a : completed.apart) {
        left.insert(a.id);
        EXPECT_EQ(a.regions, c->classes->regions(a.id));
      }
      for (std::size_t k = 0; k < c->classes->class_count(); ++k) {
        const ClassId id(k);
        if (completed.active[id] == 0) continue;
        EXPECT_EQ(left.contains(id), sets_by_edges(*c, id) > 1);
        ++(left.contains(id) ? apart : connected);
      }
    }
  }
  EXPECT_GT(apart, 0U);
  EXPECT_GT(connected, 20U);
  EXPECT_GT(fired(rules, Rule::connect_parts), 0U);
  EXPECT_GT(fired(rules, Rule::merge_sheets), 0U);
}

}  // namespace
}  // namespace tetloft::testing
