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
};

class Subdivider {
 public:
  Subdivider(const Slab& slab, const Complex& complex, RuleCounts& rules)
      : slab_(slab),
        complex_(complex),
        rules_(rules),
        midpoint_{IdVector<EdgeId, NodeId>(slab.lower().edges.size()),
                  IdVector<EdgeId, NodeId>(slab.upper().edges.size())} {}

  Subdivision run() {
    choose_midpoints();
    choose_hole_vertices();
    for (const TetId t : slab_.tets()) {
      if (complex_.attached[t] != 0) split(t);
    }
    result_.nodes = Nodes(slab_.vertex_count(), result_.lifted.size());
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool attached(TetId t, int corner) const { return complex_.is_attached(t, corner); }

  void choose_midpoints() {
    // Flags first, ids in the order of the edges afterwards: canonical.
    std::array<IdVector<EdgeId, std::uint8_t>, 2> wanted{
        IdVector<EdgeId, std::uint8_t>(slab_.lower().edges.size(), 0),
        IdVector<EdgeId, std::uint8_t>(slab_.upper().edges.size(), 0)};
    for (const TetId t : slab_.tets()) {
      if (complex_.attached[t] == 0) continue;
      for (const auto& [i, j] : kEdgeVertex) {
        if (!slab_.same_plane(t, i, j) || !(attached(t, i) || attached(t, j))) continue;
        const SlabVertexId u = slab_.vertex(t, i);
        const EdgeId e = slab_.edge(u, slab_.vertex(t, j));
        if (slab_.section_of(u).edges[e].kind == EdgeKind::external) {
          wanted[slab_.is_upper(u) ? 1 : 0][e] = 1;
        }
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
      SlabVertexId apex;
      for (int i = 0; i < 4; ++i) {
        const SlabVertexId v = slab_.vertex(t, i);
        if (slab_.is_upper(v) != upper) {
          apex = v;
          continue;
        }
        corner[corners++] = v;
        any_attached = any_attached || attached(t, i);
      }
      if (!any_attached) continue;
      bool only_contour_edges = true;
      for (std::size_t i = 0; i < 3; ++i) {
        only_contour_edges = only_contour_edges &&
                             slab_.edge_kind(corner[i], corner[(i + 1) % 3]) == EdgeKind::contour;
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
  [[nodiscard]] Node midpoint(const Node& a, const Node& b) const {
    const SlabVertexId u = Nodes::slab_vertex(a.id);
    const EdgeId e = slab_.edge(u, Nodes::slab_vertex(b.id));
    return {midpoint_[slab_.is_upper(u) ? 1 : 0][e],
            static_cast<std::uint8_t>(a.mean_of | b.mean_of)};
  }

  void split(TetId t) {
    std::array<Node, 4> corner;
    for (int i = 0; i < 4; ++i) {
      corner[static_cast<std::size_t>(i)] = {Nodes::of(slab_.vertex(t, i)),
                                             static_cast<std::uint8_t>(1U << i)};
    }
    const int highs = std::popcount(slab_.upper_corners(t));
    if (highs == 2) {
      split_type2(t, corner);
    } else {
      split_type1(t, corner, highs == 3);
    }
  }

  // An even permutation that brings the corners accepted by `first` to the front.
  template <class Test>
  static void bring_forward(std::array<Node, 4>& corner, const Test& first) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t i) { return first(corner[i]); });
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j] ? 1 : 0;
    }
    if (inversions % 2 != 0) std::swap(order[0], order[1]);
    const std::array<Node, 4> old = corner;
    for (std::size_t i = 0; i < 4; ++i) corner[i] = old[order[i]];
  }

  // Of a node that is a corner.
  [[nodiscard]] bool is_upper(const Node& n) const {
    return slab_.is_upper(Nodes::slab_vertex(n.id));
  }

  void split_type2(TetId t, std::array<Node, 4>& corner) {
    bring_forward(corner, [&](const Node& n) { return !is_upper(n); });
    const auto& [a, b, c, d] = corner;
    const Node below = midpoint(a, b);
    const Node above = midpoint(c, d);
    std::vector<std::array<Node, 2>> lows{{a, b}};
    if (below.id.valid()) lows = {{a, below}, {below, b}};
    std::vector<std::array<Node, 2>> highs{{c, d}};
    if (above.id.valid()) highs = {{c, above}, {above, d}};
    for (const auto& low : lows) {
      for (const auto& high : highs) emit(t, {low[0], low[1], high[0], high[1]});
    }
  }

  void split_type1(TetId t, std::array<Node, 4>& corner, bool triangle_above) {
    bring_forward(corner, [&](const Node& n) { return is_upper(n) == triangle_above; });
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
      mid[i] = midpoint(corner[i], corner[(i + 1) % 3]);
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
  const Complex& complex_;
  RuleCounts& rules_;
  std::array<IdVector<EdgeId, NodeId>, 2> midpoint_;  // lower, upper; invalid: none
  IdVector<TetId, NodeId> hole_vertex_;               // invalid: none
  Subdivision result_;
  std::vector<TetId> ring_;
  std::vector<SlabVertexId> opposite_;
};

}  // namespace

Subdivision subdivide(const Slab& slab, const Complex& complex, RuleCounts& rules) {
  return Subdivider(slab, complex, rules).run();
}

}  // namespace tetloft::internal
