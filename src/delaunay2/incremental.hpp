// The Delaunay triangulation under insertion: walk, conflict zone, cavity.
//
// Flat arrays: half-edge h = 3 t + i is the edge of triangle t opposite its vertex i, directed
// counter-clockwise around t. Vertex 0 is the ghost: it closes every hull edge with a ghost
// triangle, so the surface is a sphere without boundary, with 2 n − 2 triangles for n
// vertices besides the ghost; a cavity is always refilled by two triangles more than it lost,
// so no triangle is ever deleted.
//
// Invariant between insertions: the unique triangulation of its points under
// incircle_perturbed. The zone in conflict with a new point is a disc without interior
// vertices, star-shaped as seen from the point, and its dual graph is a tree: the search
// needs no marks and meets the horizon in order.
// (Bowyer 1981; Watson 1981. Walk: Devillers, Pion and Teillaud, "Walking in a triangulation",
// 2002; it ends because visibility is acyclic in regular triangulations: Edelsbrunner, "An
// acyclicity theorem for cell complexes in d dimensions", 1990.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

namespace tetloft::delaunay2_detail {

using HalfEdgeId = Id<struct HalfEdgeTag>;
/// What the owner attaches to an edge: an index into its own array.
using LabelId = Id<struct LabelTag>;

class Incremental2 {
 public:
  static constexpr VertexId kGhost{0};
  /// 6 n half-edges must have ids.
  static constexpr std::size_t kMostVertices = std::size_t{1} << 29;

  /// The triangulation of one triangle, with vertices 1, 2, 3 (and the ghost).
  /// Requires a, b, c counter-clockwise. Memory is reserved for `expected` vertices.
  Incremental2(const Point2& a, const Point2& b, const Point2& c, std::size_t expected);

  /// Inserts p; walks there from a triangle at `hint`. Returns its vertex, a new one, or that
  /// which has the same point already. Ids are given in order of insertion.
  VertexId insert(const Point2& p, VertexId hint);

  /// All vertices, the ghost included.
  [[nodiscard]] std::size_t vertex_count() const { return point_.size(); }
  /// All triangles, ghost triangles included.
  [[nodiscard]] std::size_t triangle_count() const { return vertex_.size() / 3; }
  [[nodiscard]] const Point2& point(VertexId v) const { return point_[v.index()]; }
  /// The vertex opposite half-edge h in its triangle.
  [[nodiscard]] VertexId apex(HalfEdgeId h) const { return vertex_[h.index()]; }
  [[nodiscard]] VertexId origin(HalfEdgeId h) const { return vertex_[next(h).index()]; }
  [[nodiscard]] VertexId destination(HalfEdgeId h) const { return vertex_[previous(h).index()]; }
  /// The same edge in the other triangle.
  [[nodiscard]] HalfEdgeId opposite(HalfEdgeId h) const { return opposite_[h.index()]; }
  [[nodiscard]] bool is_ghost(TriangleId t) const;

  /// The half-edge from a to b, or invalid. O(smaller degree).
  [[nodiscard]] HalfEdgeId find_edge(VertexId a, VertexId b) const;

  /// Labels the edge, on both sides. A label stays while its edge does.
  void set_label(HalfEdgeId h, LabelId label);
  /// The labels of edges of which an insertion removed a triangle, since the last call;
  /// with repetitions. The edges themselves may be gone.
  [[nodiscard]] std::vector<LabelId> take_touched();

 private:
  struct HorizonEdge {
    VertexId from;  // directed counter-clockwise around the cavity
    VertexId to;
    HalfEdgeId outer;  // the edge's side that stays
    LabelId label;
  };

  static HalfEdgeId next(HalfEdgeId h) {
    return HalfEdgeId(h.value() % 3 == 2 ? h.value() - 2 : h.value() + 1);
  }
  static HalfEdgeId previous(HalfEdgeId h) {
    return HalfEdgeId(h.value() % 3 == 0 ? h.value() + 2 : h.value() - 1);
  }
  static TriangleId triangle(HalfEdgeId h) { return TriangleId(h.value() / 3); }
  static HalfEdgeId half_edge(TriangleId t, std::uint32_t i) {
    return HalfEdgeId(3 * t.value() + i);
  }
  /// The next half-edge with the same origin, counter-clockwise.
  [[nodiscard]] HalfEdgeId rotate(HalfEdgeId h) const { return opposite(previous(h)); }

  [[nodiscard]] TriangleId locate(const Point2& p, VertexId hint) const;
  [[nodiscard]] VertexId vertex_at(const Point2& p, TriangleId t) const;
  [[nodiscard]] bool in_conflict(TriangleId t, const Point2& p) const;
  void collect_conflict_zone(const Point2& p, TriangleId first);
  void star_cavity(VertexId v);
  TriangleId add_triangle();
  void set_triangle(TriangleId t, VertexId a, VertexId b, VertexId c);
  void join(HalfEdgeId a, HalfEdgeId b);
  [[nodiscard]] LabelId label(HalfEdgeId h) const {
    return label_.empty() ? LabelId() : label_[h.index()];
  }

  std::vector<Point2> point_;         // by vertex; the ghost's means nothing
  std::vector<HalfEdgeId> out_;       // by vertex: a half-edge that starts there
  std::vector<VertexId> vertex_;      // by half-edge: the vertex it is opposite to
  std::vector<HalfEdgeId> opposite_;  // by half-edge
  std::vector<LabelId> label_;        // by half-edge, invalid without; empty before the first

  std::vector<TriangleId> zone_;      // scratch of insert()
  std::vector<HorizonEdge> horizon_;  // scratch of insert()
  std::vector<HalfEdgeId> stack_;     // scratch of collect_conflict_zone()
  std::vector<LabelId> touched_;
};

}  // namespace tetloft::delaunay2_detail
