// Around every edge of D, what is attached at an end of it is in one piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "support/slabs/steps.hpp"

namespace tetloft::testing {
namespace {

bool share_a_face(const Slab& slab, TetId a, TetId b) {
  int common = 0;
  for (int i = 0; i < 4; ++i)
    common += slab.mesh().index_in(b, VertexId(slab.vertex(a, i).value())) >= 0 ? 1 : 0;
  return common == 3;
}

// Tets around one edge hang together through faces, all of which contain the edge.
std::size_t pieces(const Slab& slab, std::vector<TetId> tets) {
  std::size_t count = 0;
  while (!tets.empty()) {
    ++count;
    std::vector<TetId> todo{tets.back()};
    tets.pop_back();
    while (!todo.empty()) {
      const TetId t = todo.back();
      todo.pop_back();
      const auto apart = std::partition(tets.begin(), tets.end(),
                                        [&](TetId u) { return !share_a_face(slab, t, u); });
      todo.insert(todo.end(), apart, tets.end());
      tets.erase(apart, tets.end());
    }
  }
  return count;
}

// By edge, the tets for which holds(tet, corner of the edge's first end); both directions.
template <class Holds>
std::map<std::pair<SlabVertexId, SlabVertexId>, std::vector<TetId>> around_edges(
    const SlabCase& c, const Holds& holds) {
  std::map<std::pair<SlabVertexId, SlabVertexId>, std::vector<TetId>> result;
  for (const TetId t : c.slab->tets()) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        if (i == j || !holds(t, i)) continue;
        result[{c.slab->vertex(t, i), c.slab->vertex(t, j)}].push_back(t);
      }
    }
  }
  return result;
}

TEST(Rings, AttachedTetsAroundAnEdgeAreOneRunOrLeaveOneGap) {
  std::size_t parted_by_the_seed = 0;
  RuleCounts rules{};
  for (const NamedSlab& s : generated_slabs(211, 2)) {
    SCOPED_TRACE(s.name);
    const SlabCase& c = *s.built;
    const Completed completed = complete(c, true);
    for (std::size_t r = 0; r < rules.size(); ++r) rules.at(r) += completed.rules.at(r);
    if (!completed.apart.empty()) continue;
    const auto attached = around_edges(
        c, [&](TetId t, int corner) { return completed.complex.is_attached(t, corner); });
    for (const auto& [edge, tets] : attached) ASSERT_EQ(pieces(*c.slab, tets), 1U);
    const auto seeded =
        around_edges(c, [&](TetId t, int corner) { return completed.seed.keeps(t, corner); });
    for (const auto& [edge, tets] : seeded) parted_by_the_seed += pieces(*c.slab, tets) - 1;
  }
  EXPECT_GT(parted_by_the_seed, 100U);
  EXPECT_GT(fired(rules, Rule::run_at_external_edge) + fired(rules, Rule::run_at_cross_edge), 0U);
  EXPECT_GT(fired(rules, Rule::gap_at_cross_edge), 0U);
}

}  // namespace
}  // namespace tetloft::testing
