// Trimming: only what overhangs goes, and the complexes of weight 1 keep their topology.
#include "subdivision/trimming.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "support/slabs/steps.hpp"

namespace tetloft::testing {

using namespace internal;
namespace {

using Simplex = std::set<NodeId>;

// By class, all simplices spanned by nodes of weight 1 in some child.
std::map<ClassId, std::set<Simplex>> weight_one(const SlabCase& c, const Subdivided& made,
                                                const IdVector<LiftedId, std::uint8_t>& trimmed) {
  std::map<ClassId, std::set<Simplex>> result;
  for (const Child& child : made.subdivision.children) {
    std::map<ClassId, unsigned> attached;
    for (int i = 0; i < 4; ++i) {
      if (!made.complex.is_attached(child.parent, i)) continue;
      attached[c.classes->of(c.slab->vertex(child.parent, i))] |= 1U << i;
    }
    for (const auto& [id, mask] : attached) {
      std::vector<NodeId> whole;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t node = child.node.at(i).index();
        const std::size_t n = c.slab->vertex_count();
        if (node >= n && trimmed[LiftedId(node - n)] != 0) continue;
        if ((child.mean_of.at(i) & ~mask) == 0) whole.push_back(child.node.at(i));
      }
      for (unsigned subset = 1; subset < (1U << whole.size()); ++subset) {
        Simplex simplex;
        for (std::size_t i = 0; i < whole.size(); ++i) {
          if (((subset >> i) & 1U) != 0) simplex.insert(whole[i]);
        }
        result[id].insert(std::move(simplex));
      }
    }
  }
  return result;
}

struct Topology {
  long euler = 0;
  std::size_t parts = 0;
  friend bool operator==(const Topology&, const Topology&) = default;
};

Topology topology_of(const std::set<Simplex>& complex) {
  Topology result;
  std::map<NodeId, NodeId> leader;
  const auto find = [&](NodeId n) {
    while (leader.at(n) != n) n = leader.at(n);
    return n;
  };
  for (const Simplex& s : complex) {
    result.euler += s.size() % 2 == 1 ? 1 : -1;
    if (s.size() == 1) leader[*s.begin()] = *s.begin();
  }
  for (const Simplex& s : complex) {
    if (s.size() == 2) leader[find(*s.begin())] = find(*s.rbegin());
  }
  for (const auto& [n, l] : leader) result.parts += n == l ? 1U : 0U;
  return result;
}

double distance_to_edges(const ConformingSection& section, const Point3& p) {
  double best = HUGE_VAL;
  for (const PlaneVertexId v : section.contour.ids()) {
    const Point2 a = section.point(v);
    const Point2 b = section.point(section.next[v]);
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double t =
        std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    best = std::min(best, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
  }
  return best;
}

// Generated slabs, made so flat that things overhang.
std::vector<NamedSlab> flat_slabs() {
  std::vector<NamedSlab> slabs;
  for (const StackKind kind : all_kinds()) {
    if (is_near_coincident(kind)) continue;
    for (std::uint64_t seed = 340; seed < 352; ++seed) {
      SectionStack stack = generate(kind, seed).stack;
      for (Section& section : stack.sections) section.z *= 0x1p-6;
      auto built = slab_case(stack, 0);
      if (built) slabs.push_back({std::string(name_of(kind)), std::move(built)});
    }
  }
  return slabs;
}

TEST(Trimming, TakesOverhangingVerticesOnlyAndLeavesTheTopology) {
  std::size_t count = 0;
  for (const NamedSlab& s : flat_slabs()) {
    SCOPED_TRACE(s.name);
    const SlabCase& c = *s.built;
    Subdivided made = subdivide_case(c);
    Lifting lifting(*c.slab, made.subdivision);
    if (!lifting.settle(made.rules)) continue;
    const auto trimmed =
        choose_trimmed(*c.slab, *c.classes, made.complex, made.subdivision, lifting);
    ASSERT_EQ(trimmed.size(), made.subdivision.lifted.size());
    std::size_t here = 0;
    for (const LiftedId k : trimmed.ids()) {
      if (trimmed[k] == 0) continue;
      ++here;
      const Point3 p = lifting.points()[NodeId(c.slab->vertex_count() + k.index())];
      const double limit = kLargestOverhang * c.slab->gap() * (1 - 1e-9);
      EXPECT_GT(distance_to_edges(c.lower, p), limit);
      EXPECT_GT(distance_to_edges(c.upper, p), limit);
    }
    count += here;
    if (here == 0) continue;
    const auto before = weight_one(c, made, IdVector<LiftedId, std::uint8_t>(trimmed.size(), 0));
    const auto after = weight_one(c, made, trimmed);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [id, complex] : before) {
      EXPECT_EQ(topology_of(complex), topology_of(after.at(id)));
    }
  }
  EXPECT_GT(count, 20U);
}

}  // namespace
}  // namespace tetloft::testing
