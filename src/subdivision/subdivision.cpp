#include "subdivision/subdivision.hpp"

#include <algorithm>
#include <bit>

#include "core/guard.hpp"
#include "core/sort_distinct.hpp"

namespace tetloft::internal {

namespace {

// A node of a child: its id and the parent's corners it is the mean of.
struct Node {
  NodeId id;
  std::uint8_t mean_of = 0;
  // Of a node that is a corner.
  [[nodiscard]] int corner() const { return std::countr_zero(unsigned{mean_of}); }
};

bool has_external_edge(TetKind kind) {
  return kind != TetKind::t1_internal && kind != TetKind::ii && kind != TetKind::ic &&
         kind != TetKind::cc;
}

class Subdivider {
 public:
  Subdivider(const Slab& slab, const SlabClasses& classes, const Complex& complex,
             RuleCounts& rules)
      : slab_(slab),
        classes_(classes),
        complex_(complex),
        rules_(rules),
        midpoint_{IdVector<EdgeId, NodeId>(slab.lower().edges.size()),
                  IdVector<EdgeId, NodeId>(slab.upper().edges.size())} {}

  Subdivision run() {
    choose_whole();
    choose_midpoints();
    choose_hole_vertices();
    for (const TetId t : slab_.tets()) {
      if (complex_.attached[t] != 0 && result_.whole[t] == 0) split(t);
    }
    result_.nodes = Nodes(slab_.vertex_count(), result_.lifted.size());
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool attached(TetId t, int corner) const { return complex_.is_attached(t, corner); }

  void choose_whole() {
    result_.whole.assign(slab_.tet_count(), 0);
    for (const TetId t : slab_.tets()) {
      if (complex_.attached[t] != kAllCorners || has_external_edge(slab_.kind(t))) continue;
      const ClassId c = classes_.of(slab_.vertex(t, 0));
      result_.whole[t] = own_corners(slab_, classes_, t, c) == kAllCorners ? 1 : 0;
    }
  }

  void choose_midpoints() {
    // Flags first, ids in the order of the edges afterwards: canonical.
    std::array<IdVector<EdgeId, std::uint8_t>, 2> wanted{
        IdVector<EdgeId, std::uint8_t>(slab_.lower().edges.size(), 0),
        IdVector<EdgeId, std::uint8_t>(slab_.upper().edges.size(), 0)};
    for (const TetId t : slab_.tets()) {
      if (complex_.attached[t] == 0 || !has_external_edge(slab_.kind(t))) continue;
      for (const auto& [i, j] : kEdgeVertex) {
        if (!slab_.same_plane(t, i, j) || !(attached(t, i) || attached(t, j))) continue;
        const bool upper = has_corner(slab_.upper_corners(t), i);
        const EdgeId e = slab_.edge(t, i, j);
        if (slab_.section(upper).edges[e].kind == EdgeKind::external) wanted[upper ? 1 : 0][e] = 1;
      }
    }
    for (const bool upper : {false, true}) {
      const auto& edges = slab_.section(upper).edges;
      for (const EdgeId e : edges.ids()) {
        if (wanted[upper ? 1 : 0][e] == 0) continue;
        const SlabVertexId u = slab_.numbering().in_slab(upper, edges[e].a);
        const SlabVertexId v = slab_.numbering().in_slab(upper, edges[e].b);
        midpoint_[upper ? 1 : 0][e] = add_midpoint(u, v, slab_.tet_at_edge(upper, e));
      }
    }
  }

  NodeId add_lifted(const LiftedVertex& vertex) {
    return Nodes(slab_.vertex_count()).of(result_.lifted.push_back(vertex));
  }

  NodeId add_midpoint(SlabVertexId u, SlabVertexId v, TetId in_ring) {
    const bool upper = slab_.is_upper(u);
    const Point3 a = slab_.point(u);
    const Point3 b = slab_.point(v);
    slab_.ring(u, v, in_ring, ring_);
    opposite_.clear();
    for (const TetId t : ring_) {
      for (const SlabVertexId w : slab_.vertices(t)) {
        if (slab_.is_upper(w) != upper) opposite_.push_back(w);
      }
    }
    sort_distinct(opposite_);
    Point3 sum{};
    for (const SlabVertexId w : opposite_) {
      const Point3 p = slab_.point(w);
      sum = {sum.x + p.x, sum.y + p.y, p.z};
    }
    const auto n = static_cast<double>(opposite_.size());
    return add_lifted({{u, v, SlabVertexId()},
                       upper,
                       {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), a.z},
                       {sum.x / n, sum.y / n, sum.z}});
  }

  void choose_hole_vertices() {
    hole_vertex_.resize(slab_.tet_count());
    for (const TetId t : slab_.tets()) {
      if (slab_.kind(t) != TetKind::t1_external || complex_.attached[t] == 0) continue;
      const bool upper = std::popcount(slab_.upper_corners(t)) == 3;
      std::array<SlabVertexId, 3> corner;
      std::size_t corners = 0;
      bool any_attached = false;
      std::array<int, 3> at{};
      SlabVertexId apex;
      for (int i = 0; i < 4; ++i) {
        const SlabVertexId v = slab_.vertex(t, i);
        if (slab_.is_upper(v) != upper) {
          apex = v;
          continue;
        }
        at[corners] = i;
        corner[corners++] = v;
        any_attached = any_attached || attached(t, i);
      }
      if (!any_attached) continue;
      bool only_contour_edges = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const EdgeId e = slab_.edge(t, at[i], at[(i + 1) % 3]);
        only_contour_edges =
            only_contour_edges && slab_.section(upper).edges[e].kind == EdgeKind::contour;
      }
      if (!only_contour_edges) continue;
      count(rules_, Rule::triangular_hole);
      const Point3 a = slab_.point(corner[0]);
      const Point3 b = slab_.point(corner[1]);
      const Point3 c = slab_.point(corner[2]);
      hole_vertex_[t] = add_lifted(
          {corner, upper, {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, a.z}, slab_.point(apex)});
    }
  }

  void emit(TetId parent, const std::array<Node, 4>& nodes) {
    Child child;
    child.parent = parent;
    for (std::size_t i = 0; i < 4; ++i) {
      child.node[i] = nodes[i].id;
      child.mean_of[i] = nodes[i].mean_of;
    }
    result_.children.push_back(child);
  }

  // The midpoint between two corners of t, invalid id if the edge has none.
  [[nodiscard]] Node midpoint(TetId t, const Node& a, const Node& b) const {
    const EdgeId e = slab_.edge(t, a.corner(), b.corner());
    return {midpoint_[has_corner(slab_.upper_corners(t), a.corner()) ? 1 : 0][e],
            static_cast<std::uint8_t>(a.mean_of | b.mean_of)};
  }

  void split(TetId t) {
    std::array<Node, 4> corner;
    const std::uint8_t upper = slab_.upper_corners(t);
    for (std::size_t k = 0; k < 4; ++k) {
      const int i = corners_by_plane(upper)[k];
      corner[k] = {Nodes::of(slab_.vertex(t, i)), static_cast<std::uint8_t>(1U << i)};
    }
    if (std::popcount(upper) == 2) {
      split_type2(t, corner);
    } else {
      split_type1(t, corner);
    }
  }

  // Corners as corners_by_plane() has them.
  void split_type2(TetId t, const std::array<Node, 4>& corner) {
    const auto& [a, b, c, d] = corner;
    const Node below = midpoint(t, a, b);
    const Node above = midpoint(t, c, d);
    using Half = std::array<Node, 2>;
    const std::array<Half, 2> lows{Half{a, below.id.valid() ? below : b}, Half{below, b}};
    const std::array<Half, 2> highs{Half{c, above.id.valid() ? above : d}, Half{above, d}};
    for (std::size_t i = 0; i < (below.id.valid() ? 2U : 1U); ++i) {
      for (std::size_t j = 0; j < (above.id.valid() ? 2U : 1U); ++j) {
        emit(t, {lows[i][0], lows[i][1], highs[j][0], highs[j][1]});
      }
    }
  }

  void split_type1(TetId t, const std::array<Node, 4>& corner) {
    const Node apex = corner[3];
    if (hole_vertex_[t].valid()) {
      const Node x{hole_vertex_[t], static_cast<std::uint8_t>(
                                        corner[0].mean_of | corner[1].mean_of | corner[2].mean_of)};
      for (std::size_t i = 0; i < 3; ++i) emit(t, {corner[i], corner[(i + 1) % 3], x, apex});
      return;
    }
    // mid[i] lies between corners i and i + 1.
    std::array<Node, 3> mid;
    int mids = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      mid[i] = midpoint(t, corner[i], corner[(i + 1) % 3]);
      mids += mid[i].id.valid() ? 1 : 0;
    }
    if (mids == 0) {
      emit(t, corner);
      return;
    }
    if (mids == 3) {
      for (std::size_t i = 0; i < 3; ++i) emit(t, {corner[i], mid[i], mid[(i + 2) % 3], apex});
      emit(t, {mid[0], mid[1], mid[2], apex});
      return;
    }
    // Rotate so that one midpoint is mid[0], or two are mid[0] and mid[2] around corner 0.
    std::size_t r = 0;
    while (mids == 1 ? !mid[r].id.valid() : mid[(r + 1) % 3].id.valid()) ++r;
    const Node a = corner[r];
    const Node b = corner[(r + 1) % 3];
    const Node c = corner[(r + 2) % 3];
    const Node ab = mid[r];
    const Node ca = mid[(r + 2) % 3];
    if (mids == 1) {
      emit(t, {a, ab, c, apex});
      emit(t, {ab, b, c, apex});
      return;
    }
    emit(t, {a, ab, ca, apex});
    if (b.id < c.id) {  // diagonal from the lower corner
      emit(t, {ab, b, ca, apex});
      emit(t, {b, c, ca, apex});
    } else {
      emit(t, {ab, b, c, apex});
      emit(t, {ab, c, ca, apex});
    }
  }

  const Slab& slab_;
  const SlabClasses& classes_;
  const Complex& complex_;
  RuleCounts& rules_;
  std::array<IdVector<EdgeId, NodeId>, 2> midpoint_;  // lower, upper; invalid: none
  IdVector<TetId, NodeId> hole_vertex_;               // invalid: none
  Subdivision result_;
  std::vector<TetId> ring_;
  std::vector<SlabVertexId> opposite_;
};

// By mask of upper corners: those of the triangle, or the lower ones, before the others, in their
// order but for the first two where that would be an odd permutation.
constexpr std::array<std::array<int, 4>, 16> orders_by_plane() {
  std::array<std::array<int, 4>, 16> orders{};
  for (unsigned mask = 0; mask < orders.size(); ++mask) {
    const unsigned first = std::popcount(mask) == 3 ? mask : ~mask;
    std::array<int, 4>& order = orders[mask];
    std::size_t next = 0;
    int passed = 0;
    for (const bool front : {true, false}) {
      for (int i = 0; i < 4; ++i) {
        if (has_corner(first, i) != front) continue;
        if (front) passed += i - static_cast<int>(next);
        order[next++] = i;
      }
    }
    if (passed % 2 != 0) std::swap(order[0], order[1]);
  }
  return orders;
}

}  // namespace

const std::array<int, 4>& corners_by_plane(std::uint8_t upper) {
  static constexpr std::array<std::array<int, 4>, 16> kOrders = orders_by_plane();
  return kOrders[upper];
}

Subdivision subdivide(const Slab& slab, const SlabClasses& classes, const Complex& complex,
                      RuleCounts& rules) {
  return Subdivider(slab, classes, complex, rules).run();
}

}  // namespace tetloft::internal
