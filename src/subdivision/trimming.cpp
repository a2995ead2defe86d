#include "subdivision/trimming.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/sort_distinct.hpp"
#include "core/union_find.hpp"
#include "subdivision/trimming_distance.hpp"

namespace tetloft::internal {

namespace {

class Trimmer {
 public:
  Trimmer(const Slab& slab, const SlabClasses& classes, const Complex& complex,
          const Subdivision& subdivision, const Lifting& lifting)
      : slab_(slab),
        classes_(classes),
        complex_(complex),
        subdivision_(subdivision),
        lifting_(lifting),
        nodes_(subdivision.nodes),
        lower_(slab.lower()),
        upper_(slab.upper()) {}

  IdVector<LiftedId, std::uint8_t> run() {
    trimmed_.assign(subdivision_.lifted.size(), 0);
    std::vector<std::pair<double, LiftedId>> overhanging;
    for (const LiftedId k : trimmed_.ids()) {
      const double overhang = overhang_of(k);
      if (overhang > kLargestOverhang * slab_.gap()) overhanging.emplace_back(-overhang, k);
    }
    if (overhanging.empty()) return trimmed_;
    std::sort(overhanging.begin(), overhanging.end());
    collect_children(overhanging);
    for (const auto& entry : overhanging) {
      if (collapsible_link(entry.second)) trimmed_[entry.second] = 1;
    }
    return trimmed_;
  }

 private:
  [[nodiscard]] double overhang_of(LiftedId k) const {
    const LiftedVertex& vertex = subdivision_.lifted[k];
    const Point3& at = lifting_.points()[nodes_.of(k)];
    const Point2 p{at.x, at.y};
    const double enough = kLargestOverhang * slab_.gap();
    for (const SlabVertexId v : vertex.of) {
      if (!v.valid()) continue;
      const Point3 end = slab_.point(v);
      if (std::hypot(end.x - p.x, end.y - p.y) <= enough) return 0;
    }
    if (lower_.contains(p) || upper_.contains(p)) return 0;
    const double below = lower_.distance(p, enough);
    return below <= enough ? 0 : std::min(below, upper_.distance(p, enough));
  }

  // The children at each overhanging vertex in which it has weight 1.
  void collect_children(const std::vector<std::pair<double, LiftedId>>& overhanging) {
    IdVector<LiftedId, std::uint8_t> wanted(subdivision_.lifted.size(), 0);
    for (const auto& entry : overhanging) wanted[entry.second] = 1;
    for (std::size_t c = 0; c < subdivision_.children.size(); ++c) {
      const Child& child = subdivision_.children[c];
      for (std::size_t i = 0; i < 4; ++i) {
        if (!nodes_.is_lifted(child.node[i])) continue;
        const LiftedId k = nodes_.lifted(child.node[i]);
        if (wanted[k] == 0) continue;
        if ((child.mean_of[i] & ~unsigned{complex_.attached[child.parent]}) != 0) continue;
        children_.emplace_back(k, c);
      }
    }
    std::sort(children_.begin(), children_.end());
  }

  // Is the link of lifted vertex k in F, as trimmed so far, connected and of χ = 1?
  [[nodiscard]] bool collapsible_link(LiftedId k) const {
    const NodeId self = nodes_.of(k);
    std::vector<NodeId> vertices;
    std::vector<std::array<NodeId, 2>> edges;
    std::vector<std::array<NodeId, 3>> triangles;
    for (auto at =
             std::lower_bound(children_.begin(), children_.end(), std::pair(k, std::size_t{0}));
         at != children_.end() && at->first == k; ++at) {
      std::vector<NodeId> simplex = whole_corners(subdivision_.children[at->second], self);
      std::sort(simplex.begin(), simplex.end());
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        vertices.push_back(simplex[i]);
        for (std::size_t j = i + 1; j < simplex.size(); ++j)
          edges.push_back({simplex[i], simplex[j]});
      }
      if (simplex.size() == 3) triangles.push_back({simplex[0], simplex[1], simplex[2]});
    }
    sort_distinct(vertices);
    sort_distinct(edges);
    sort_distinct(triangles);
    if (vertices.size() + triangles.size() != edges.size() + 1) return false;
    UnionFind parts(vertices.size());
    std::size_t count = vertices.size();
    const auto index = [&](NodeId v) {
      return static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                      vertices.begin());
    };
    for (const auto& [u, v] : edges) count -= parts.unite(index(u), index(v)) ? 1U : 0U;
    return count == 1;
  }

  // The corners of weight 1 for the class of `self`, but itself.
  [[nodiscard]] std::vector<NodeId> whole_corners(const Child& child, NodeId self) const {
    std::uint8_t ends = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (child.node[i] == self) ends = child.mean_of[i];
    }
    const ClassId c = classes_.of(slab_.vertex(child.parent, std::countr_zero(unsigned{ends})));
    // The class's attached corners of the parent.
    const unsigned own =
        complex_.attached[child.parent] & own_corners(slab_, classes_, child.parent, c);
    std::vector<NodeId> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const NodeId v = child.node[i];
      if (v == self || (child.mean_of[i] & ~own) != 0) continue;
      if (nodes_.is_lifted(v) && trimmed_[nodes_.lifted(v)] != 0) continue;
      corners.push_back(v);
    }
    return corners;
  }

  const Slab& slab_;
  const SlabClasses& classes_;
  const Complex& complex_;
  const Subdivision& subdivision_;
  const Lifting& lifting_;
  const Nodes nodes_;
  RegionDistance lower_;
  RegionDistance upper_;
  IdVector<LiftedId, std::uint8_t> trimmed_;
  std::vector<std::pair<LiftedId, std::size_t>> children_;  // sorted
};

}  // namespace

IdVector<LiftedId, std::uint8_t> choose_trimmed(const Slab& slab, const SlabClasses& classes,
                                                const Complex& complex,
                                                const Subdivision& subdivision,
                                                const Lifting& lifting) {
  return Trimmer(slab, classes, complex, subdivision, lifting).run();
}

}  // namespace tetloft::internal
