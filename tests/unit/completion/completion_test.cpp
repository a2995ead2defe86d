// The invariants of completion on generated slabs, against sets.
#include "completion/completion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "core/union_find.hpp"
#include "support/slabs/disc_oracle.hpp"
#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// Calls visit(slab case, its completion) for slabs of all kinds, with lone classes in and out.
template <class Visit>
void for_each_completion(std::uint64_t seed, const Visit& visit) {
  for (const NamedSlab& s : generated_slabs(seed, 1)) {
    for (const bool lone_too : {false, true}) {
      SCOPED_TRACE(s.name + (lone_too ? ", lone classes too" : ""));
      const Completed completed = complete(*s.built, lone_too);
      if (!completed.apart.empty()) continue;  // refined before anything is built
      visit(*s.built, completed);
    }
  }
}

TEST(Completion, KeepsTheSeed) {
  for_each_completion(200, [](const SlabCase&, const Completed& c) {
    for (std::size_t k = 0; k < c.seed.kept.size(); ++k) {
      const TetId t(k);
      EXPECT_EQ(c.seed.kept[t] & ~c.complex.kept[t], 0);
    }
  });
}

TEST(Completion, KeptBitsAreEqualAmongCornersOfAClassAndCoverAttachedBits) {
  for_each_completion(201, [](const SlabCase& s, const Completed& c) {
    for (std::size_t k = 0; k < c.complex.kept.size(); ++k) {
      const TetId t(k);
      EXPECT_EQ(c.complex.attached[t] & ~c.complex.kept[t], 0);
      std::map<ClassId, std::set<bool>> kept;
      for (int i = 0; i < 4; ++i) {
        const ClassId id = s.classes->of(s.slab->vertex(t, i));
        kept[id].insert(c.complex.keeps(t, i));
        if (c.active[id] == 0) {
          EXPECT_FALSE(c.complex.keeps(t, i));
        }
      }
      for (const auto& [id, bits] : kept) EXPECT_EQ(bits.size(), 1U);
    }
  });
}

TEST(Completion, AttachedTetsAtEveryVertexHaveADiscAsLink) {
  std::size_t discs = 0;
  for_each_completion(202, [&](const SlabCase& s, const Completed& c) {
    for (std::size_t k = 0; k < s.slab->vertex_count(); ++k) {
      const SlabVertexId v(k);
      if (c.active[s.classes->of(v)] == 0) continue;
      EXPECT_EQ(not_a_disc(link_of(*s.slab, c.complex.attached, v)), "") << "at vertex " << k;
      ++discs;
    }
  });
  EXPECT_GT(discs, 1000U);
}

TEST(Completion, AttachedSetsOfBothEndsOfAnOwnEdgeAreEqualOrDisjoint) {
  for_each_completion(203, [](const SlabCase& s, const Completed& c) {
    struct Sets {
      std::set<TetId> low, high;
    };
    std::map<std::pair<SlabVertexId, SlabVertexId>, Sets> at_edge;
    for (std::size_t k = 0; k < c.complex.kept.size(); ++k) {
      const TetId t(k);
      for (const auto& [i, j] : kEdgeVertex) {
        const SlabVertexId u = s.slab->vertex(t, i);
        const SlabVertexId v = s.slab->vertex(t, j);
        if (s.classes->of(u) != s.classes->of(v)) continue;
        Sets& sets = at_edge[std::minmax(u, v)];
        if (c.complex.is_attached(t, u < v ? i : j)) sets.low.insert(t);
        if (c.complex.is_attached(t, u < v ? j : i)) sets.high.insert(t);
      }
    }
    for (const auto& [edge, sets] : at_edge) {
      if (sets.low == sets.high) continue;
      for (const TetId t : sets.low) EXPECT_FALSE(sets.high.contains(t));
    }
  });
}

TEST(Completion, EveryActiveClassIsConnectedThroughAttachedCorners) {
  std::size_t connected = 0;
  for_each_completion(204, [&](const SlabCase& s, const Completed& c) {
    // Corners as nodes: those of a tet for one class, and those of a vertex, hang together.
    UnionFind sets(s.slab->vertex_count());
    for (std::size_t k = 0; k < c.complex.kept.size(); ++k) {
      const TetId t(k);
      for (const auto& [i, j] : kEdgeVertex) {
        const SlabVertexId u = s.slab->vertex(t, i);
        const SlabVertexId v = s.slab->vertex(t, j);
        if (s.classes->of(u) == s.classes->of(v) && c.complex.is_attached(t, i) &&
            c.complex.is_attached(t, j)) {
          sets.unite(u.index(), v.index());
        }
      }
    }
    std::map<ClassId, std::set<std::size_t>> bodies;
    for (std::size_t v = 0; v < s.slab->vertex_count(); ++v) {
      bodies[s.classes->of(SlabVertexId(v))].insert(sets.find(v));
    }
    for (const auto& [id, parts] : bodies) {
      if (c.active[id] == 0) continue;
      EXPECT_EQ(parts.size(), 1U);
      if (!s.classes->is_lone(id)) ++connected;
    }
  });
  EXPECT_GT(connected, 20U);
}

}  // namespace
}  // namespace tetloft::testing
