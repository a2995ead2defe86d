#include "subdivision/subdivision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <vector>

#include <tetloft/predicates.hpp>

#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

// Where a node lies before it is lifted.
Point3 unlifted(const SlabCase& c, const Subdivision& subdivision, NodeId node) {
  const std::size_t n = c.slab->vertex_count();
  return node.index() < n ? c.slab->point(SlabVertexId(node.index()))
                          : subdivision.lifted[LiftedId(node.index() - n)].base;
}

std::array<NodeId, 4> as_nodes(const std::array<SlabVertexId, 4>& corners) {
  std::array<NodeId, 4> nodes;
  for (std::size_t i = 0; i < 4; ++i) nodes[i] = NodeId(corners[i].index());
  return nodes;
}

// A whole tet is its own child.
std::map<TetId, std::vector<Child>> children_by_parent(const SlabCase& c,
                                                       const Subdivision& subdivision) {
  std::map<TetId, std::vector<Child>> result;
  for (const Child& child : subdivision.children) result[child.parent].push_back(child);
  for (const TetId t : subdivision.whole.ids()) {
    if (subdivision.whole[t] == 0) continue;
    EXPECT_FALSE(result.contains(t));
    result[t].push_back({as_nodes(c.slab->vertices(t)), {1, 2, 4, 8}, t});
  }
  return result;
}

// Slabs on small lattices, where midpoints are doubles.
std::vector<NamedSlab> lattice_slabs() {
  std::vector<NamedSlab> slabs;
  for (const StackKind kind : {StackKind::lattice_marching_squares, StackKind::lattice_staircase,
                               StackKind::small_grid, StackKind::checkerboard}) {
    for (std::uint64_t seed = 300; seed < 304; ++seed) {
      const SectionStack stack = generate(kind, seed).stack;
      for (std::size_t k = 0; k + 1 < stack.sections.size(); ++k) {
        auto built = slab_case(stack, k);
        if (built)
          slabs.push_back({std::string(name_of(kind)) + std::to_string(seed), std::move(built)});
      }
    }
  }
  return slabs;
}

TEST(Subdivision, UnliftedChildrenTileTheirParent) {
  std::size_t parents = 0;
  for (const NamedSlab& s : lattice_slabs()) {
    SCOPED_TRACE(s.name);
    const SlabCase& c = *s.built;
    const Subdivided result = subdivide_case(c);
    const Subdivision& subdivision = result.subdivision;
    for (const auto& [parent, children] : children_by_parent(c, subdivision)) {
      const auto volume_of = [&](const std::array<NodeId, 4>& node) {
        std::array<Point3, 4> p;
        for (std::size_t i = 0; i < 4; ++i) p[i] = unlifted(c, subdivision, node[i]);
        EXPECT_EQ(orient3d(p[0], p[1], p[2], p[3]), Sign::positive);
        return volume6(p[0], p[1], p[2], p[3]);
      };
      long double sum = 0;
      for (const Child& child : children) sum += volume_of(child.node);
      const long double whole = volume_of(as_nodes(c.slab->vertices(parent)));
      EXPECT_NEAR(static_cast<double>(sum / whole), 1, 1e-12);
      ++parents;
    }
  }
  EXPECT_GT(parents, 100U);
}

TEST(Subdivision, SplitsExactlyExternalEdgesThatHaveAnAttachedEnd) {
  std::set<std::size_t> counts_of_type1;
  std::set<std::size_t> counts_of_type2;
  for (const NamedSlab& s : generated_slabs(301, 2)) {
    SCOPED_TRACE(s.name);
    const SlabCase& c = *s.built;
    const Subdivided result = subdivide_case(c);
    const auto attached_at = [&](TetId t, SlabVertexId v) {
      const int i = c.slab->mesh().index_in(t, VertexId(v.value()));
      return i >= 0 && result.complex.is_attached(t, i);
    };
    const auto has_midpoint = [&](SlabVertexId u, SlabVertexId v) {
      if (c.slab->edge_kind(u, v) != EdgeKind::external) return false;
      const std::vector<TetId> around =
          c.slab->mesh().star(VertexId(u.index()), VertexId(v.index()));
      return std::any_of(around.begin(), around.end(),
                         [&](TetId t) { return attached_at(t, u) || attached_at(t, v); });
    };
    const auto children = children_by_parent(c, result.subdivision);
    for (std::size_t k = 0; k < c.slab->tet_count(); ++k) {
      const TetId t(k);
      if (result.complex.attached[t] == 0) {
        EXPECT_FALSE(children.contains(t));
        continue;
      }
      std::size_t low = 0;
      std::size_t high = 0;
      for (const auto& [i, j] : kEdgeVertex) {
        const SlabVertexId u = c.slab->vertex(t, i);
        if (!c.slab->same_plane(t, i, j) || !has_midpoint(u, c.slab->vertex(t, j))) continue;
        ++(c.slab->is_upper(u) ? high : low);
      }
      const std::size_t count = children.at(t).size();
      if (std::popcount(c.slab->upper_corners(t)) == 2) {
        EXPECT_EQ(count, (1 + low) * (1 + high));
        counts_of_type2.insert(count);
        continue;
      }
      const auto& lifted = result.subdivision.lifted;
      const bool hole =
          std::any_of(children.at(t).begin(), children.at(t).end(), [&](const Child& child) {
            return std::any_of(child.mean_of.begin(), child.mean_of.end(),
                               [](std::uint8_t mask) { return std::popcount(mask) == 3; });
          });
      EXPECT_EQ(count, hole ? 3 : 1 + low + high) << lifted.size();
      if (!hole) counts_of_type1.insert(count);
    }
  }
  EXPECT_EQ(counts_of_type1, (std::set<std::size_t>{1, 2, 3, 4}));
  EXPECT_EQ(counts_of_type2, (std::set<std::size_t>{1, 2, 4}));
}

TEST(Subdivision, MeanOfNamesTheParentsCornersOfANode) {
  for (const NamedSlab& s : generated_slabs(303, 1)) {
    SCOPED_TRACE(s.name);
    const SlabCase& c = *s.built;
    const Subdivided result = subdivide_case(c);
    for (const Child& child : result.subdivision.children) {
      for (std::size_t i = 0; i < 4; ++i) {
        std::set<SlabVertexId> named;
        for (int corner = 0; corner < 4; ++corner) {
          if (has_corner(child.mean_of[i], corner)) {
            named.insert(c.slab->vertex(child.parent, corner));
          }
        }
        const std::size_t node = child.node[i].index();
        std::set<SlabVertexId> expected{SlabVertexId(node)};
        if (node >= c.slab->vertex_count()) {
          const auto& of = result.subdivision.lifted[LiftedId(node - c.slab->vertex_count())].of;
          expected = {of.begin(), of.end()};
          expected.erase(SlabVertexId());
        }
        EXPECT_EQ(named, expected);
      }
    }
  }
}

TEST(Subdivision, ATriangularHoleGetsAnInnerVertexAndThreeChildren) {
  const Contour hole{{{-1, -1}, {1, -1}, {0, 1}}};
  const auto c = slab_case(stack_of_boxes({{box(-9, -9, 9, 9), hole}, {box(-9, -9, 9, 9)}}), 0);
  const Subdivided result = subdivide_case(*c);
  EXPECT_EQ(result.rules[static_cast<std::size_t>(Rule::triangular_hole)], 1U);
  std::size_t inner = 0;
  for (const LiftedVertex& v : result.subdivision.lifted) {
    if (!v.of[2].valid()) continue;
    ++inner;
    EXPECT_FALSE(v.upper);
    EXPECT_EQ(v.base.x, 0);
    EXPECT_NEAR(v.base.y, -1.0 / 3, 1e-15);
  }
  EXPECT_EQ(inner, 1U);
  for (const auto& [parent, children] : children_by_parent(*c, result.subdivision)) {
    if (c->slab->kind(parent) == TetKind::t1_external) {
      EXPECT_EQ(children.size(), 3U);
    }
  }
}

}  // namespace
}  // namespace tetloft::testing
