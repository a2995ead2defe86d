// The Delaunay triangulation under insertion: walk, conflict zone, cavity.
//
// Half-edge h = 4 t + i, i < 3, is the edge of triangle t opposite its vertex i, directed
// counter-clockwise around t; a triangle is a record of half a cache line. Vertex 0 is the ghost:
// it closes every hull edge with a ghost triangle, so the surface is a sphere without boundary,
// with 2 n − 2 triangles for n vertices besides the ghost; a cavity is always refilled by two
// triangles more than it lost. Where a vertex goes the last two triangles take the places of those
// that go with it.
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
#include <tetloft/predicates.hpp>

#include "predicates/plane_filter.hpp"

namespace tetloft::internal::delaunay2_detail {

/// A vertex of the triangulation under insertion: the ghost, then in order of insertion.
using SiteId = Id<struct SiteTag>;
using HalfEdgeId = Id<struct HalfEdgeTag>;
/// What the owner attaches to an edge: an index into its own array.
using LabelId = Id<struct LabelTag>;

class Incremental2 {
 public:
  static constexpr SiteId kGhost{0};
  /// 2 n triangles of four ids each.
  static constexpr std::size_t kMostVertices = std::size_t{1} << 29;

  /// The triangulation of one triangle, with vertices 1, 2, 3 (and the ghost).
  /// Requires a, b, c counter-clockwise. Memory is reserved for `expected` vertices. `filter` is
  /// one of a set that holds a, b, c; it lasts while points of that set are inserted.
  Incremental2(const Point2& a, const Point2& b, const Point2& c, std::size_t expected,
               const predicates::PlaneFilter& filter = {});

  /// Inserts p; walks there from a triangle at `hint`. Returns its vertex, a new one, or that
  /// which has the same point already. Ids are given in order of insertion.
  SiteId insert(const Point2& p, SiteId hint) { return insert(p, triangle(out_[hint.index()])); }
  /// The same from the triangle made last: for points near the one inserted before.
  SiteId insert_nearby(const Point2& p) { return insert(p, last_); }

  /// Removes v. Other vertices keep their ids, triangles do not; the id is given again. If memory
  /// ends, nothing has happened. Requires three vertices beside v that are not collinear.
  void remove(SiteId v);
  /// A triangle that contains p, its boundary included, or a ghost triangle whose hull edge has p
  /// strictly outside. Walks there from `hint`; changes nothing.
  [[nodiscard]] TriangleId locate(const Point2& p, SiteId hint) const {
    predicates::PlaneFilter filter = filter_;
    filter.admit(p);
    return locate(filter, p, triangle(out_[hint.index()]));
  }
  /// The vertex of t at p, or invalid.
  [[nodiscard]] SiteId vertex_at(const Point2& p, TriangleId t) const;
  /// What an insertion removes, and the edges that it joins to the new vertex.
  struct HorizonEdge {
    SiteId from;  ///< directed counter-clockwise around the cavity
    SiteId to;
    HalfEdgeId outer;  ///< the edge's side that stays
    LabelId label;
  };
  struct Conflict {
    std::vector<TriangleId> zone;
    std::vector<HorizonEdge> horizon;  ///< in order, counter-clockwise
  };
  /// That of p, for t as locate() finds it. Requires that p is no vertex of t. Changes nothing.
  [[nodiscard]] Conflict conflict(const Point2& p, TriangleId t) const;

  // Labelled edges as walls: what is behind one is not seen, and counts for nothing in circles. The
  // triangulation is the constrained one then, unique like the other. See walls.cpp.

  /// From now on labelled edges are walls; while there are none, nothing changes.
  void respect_labels() { walls_ = true; }
  /// What one comes to on the way from a to another vertex b.
  struct Passage {
    SiteId reached;   ///< the first vertex on the segment
    HalfEdgeId wall;  ///< the first wall that the segment crosses before, if any
  };
  [[nodiscard]] Passage passage(SiteId a, SiteId b) const;
  /// Makes a b an edge and a wall. Requires that a passage leads to b without a wall. If memory
  /// ends, nothing has happened.
  void make_wall(SiteId a, SiteId b, LabelId label);
  /// The edge a b is no wall any more. Requires that it is one.
  void remove_wall(SiteId a, SiteId b);
  /// The wall that has p inside, for t as locate() finds it; or invalid. An insertion of p divides
  /// it.
  [[nodiscard]] HalfEdgeId wall_at(const Point2& p, TriangleId t) const;
  [[nodiscard]] bool is_wall(HalfEdgeId h) const { return walls_ && label(h).valid(); }

  /// All vertices, the ghost included, and the ids of those that were removed.
  [[nodiscard]] std::size_t vertex_count() const { return point_.size(); }
  /// All triangles, ghost triangles included.
  [[nodiscard]] std::size_t triangle_count() const { return triangles_.size(); }
  [[nodiscard]] const Point2& point(SiteId v) const { return point_[v.index()]; }
  [[nodiscard]] static TriangleId triangle(HalfEdgeId h) { return TriangleId(h.value() / 4); }
  [[nodiscard]] static HalfEdgeId half_edge(TriangleId t, std::uint32_t i) {
    return HalfEdgeId(4 * t.value() + i);
  }
  /// The vertices of t, counter-clockwise.
  [[nodiscard]] const std::array<SiteId, 3>& vertices(TriangleId t) const {
    return triangles_[t.index()].apex;
  }
  /// The vertex opposite half-edge h in its triangle.
  [[nodiscard]] SiteId apex(HalfEdgeId h) const { return at(h).apex[h.value() & 3U]; }
  [[nodiscard]] SiteId origin(HalfEdgeId h) const { return apex(next(h)); }
  [[nodiscard]] SiteId destination(HalfEdgeId h) const { return apex(previous(h)); }
  /// The same edge in the other triangle.
  [[nodiscard]] HalfEdgeId opposite(HalfEdgeId h) const { return at(h).opposite[h.value() & 3U]; }
  /// The following and the preceding edge of its triangle.
  [[nodiscard]] static HalfEdgeId next(HalfEdgeId h) {
    return HalfEdgeId((h.value() & 3U) == 2 ? h.value() - 2 : h.value() + 1);
  }
  [[nodiscard]] static HalfEdgeId previous(HalfEdgeId h) {
    return HalfEdgeId((h.value() & 3U) == 0 ? h.value() + 2 : h.value() - 1);
  }
  /// Some half-edge that starts at v.
  [[nodiscard]] HalfEdgeId out(SiteId v) const { return out_[v.index()]; }
  /// The next half-edge with the same origin, counter-clockwise.
  [[nodiscard]] HalfEdgeId rotate(HalfEdgeId h) const { return opposite(previous(h)); }
  /// The one before.
  [[nodiscard]] HalfEdgeId rotate_back(HalfEdgeId h) const { return next(opposite(h)); }
  [[nodiscard]] bool is_ghost(TriangleId t) const {
    const std::array<SiteId, 3>& v = vertices(t);
    return v[0] == kGhost || v[1] == kGhost || v[2] == kGhost;
  }

  /// The half-edge from a to b, or invalid. O(smaller degree).
  [[nodiscard]] HalfEdgeId find_edge(SiteId a, SiteId b) const;

  /// The edge that the segment from a to b leaves the star of a by, its origin to the right; or
  /// invalid, and `along` is the neighbour of a on the segment.
  [[nodiscard]] HalfEdgeId first_crossed(SiteId a, SiteId b, SiteId& along) const;
  /// The first vertex that the segment from a to b meets. `cross(h)` is told of all edges that it
  /// crosses before, in order, h from the right of the segment to its left.
  template <class Cross>
  SiteId follow(SiteId a, SiteId b, const Cross& cross) const {
    SiteId met;
    HalfEdgeId h = first_crossed(a, b, met);
    while (!met.valid()) {
      cross(h);
      const HalfEdgeId across = opposite(h);
      const SiteId v = apex(across);
      const Sign side = side_of_segment(a, b, v);
      if (side == Sign::zero) met = v;
      h = side == Sign::positive ? next(across) : previous(across);
    }
    return met;
  }

  /// Labels the edge, on both sides. A label stays while its edge does.
  void set_label(HalfEdgeId h, LabelId label);
  /// The labels of edges of which an insertion removed a triangle, since the last call;
  /// with repetitions. The edges themselves may be gone.
  [[nodiscard]] std::vector<LabelId> take_touched();

 private:
  struct alignas(32) Triangle {
    std::array<SiteId, 3> apex;          // the vertex that half-edge i is opposite to
    std::array<HalfEdgeId, 3> opposite;  // the other side of half-edge i
  };
  [[nodiscard]] const Triangle& at(HalfEdgeId h) const { return triangles_[triangle(h).index()]; }
  void set_opposite(HalfEdgeId h, HalfEdgeId other) {
    triangles_[triangle(h).index()].opposite[h.value() & 3U] = other;
  }

  using Filter = predicates::PlaneFilter;
  SiteId insert(const Point2& p, TriangleId hint);
  [[nodiscard]] bool is_right_of(const Filter& filter, const Point2& p, SiteId from,
                                 SiteId to) const;
  [[nodiscard]] bool decide_right_of(const Filter& filter, const Point2& p, SiteId from,
                                     SiteId to) const;
  [[nodiscard]] TriangleId locate(const Filter& filter, const Point2& p, TriangleId hint) const;
  [[nodiscard]] TriangleId walk_among_walls(const Filter& filter, const Point2& p,
                                            HalfEdgeId entry) const;
  [[nodiscard]] bool in_conflict(const Filter& filter, TriangleId t, const Point2& p) const;
  [[nodiscard]] bool decide_conflict(const Filter& filter, TriangleId t, const Point2& p) const;
  void collect_conflict(const Filter& filter, const Point2& p, TriangleId first, HalfEdgeId open,
                        Conflict& conflict, std::vector<HalfEdgeId>& stack) const;
  void note_touched();
  void provide_memory();
  [[nodiscard]] SiteId take_site(const Point2& p);
  void star_cavity(SiteId v);

  // removal.cpp
  [[nodiscard]] Sign turn(SiteId a, SiteId b, SiteId c) const;
  [[nodiscard]] HalfEdgeId to_first_of_hull(SiteId v) const;
  void flip(HalfEdgeId h);
  void flip_for_good(HalfEdgeId h);
  std::array<TriangleId, 2> take_from_inside(SiteId v);
  std::array<TriangleId, 2> take_from_hull(HalfEdgeId first);
  void flip_with_sides(HalfEdgeId h);
  void push(HalfEdgeId h);
  [[nodiscard]] bool is_illegal(HalfEdgeId h) const;
  void flip_illegal_edges();
  void delete_triangle(TriangleId t);

  // walls.cpp
  struct Corner {
    SiteId vertex;
    SiteId from;  // clockwise from what is to become the new edge beside the vertex
    SiteId to;
  };
  [[nodiscard]] Sign side_of_segment(SiteId a, SiteId b, SiteId v) const;
  [[nodiscard]] Corner corner_between(SiteId a, SiteId b) const;
  void cut_off(const Corner& corner);
  [[nodiscard]] LabelId label(HalfEdgeId h) const {
    return label_.empty() ? LabelId() : label_[h.index()];
  }

  // By vertex. The ghost's is NaN, so that filters do not answer where it takes part: the usual
  // case needs no test for it.
  std::vector<Point2> point_;
  std::vector<HalfEdgeId> out_;  // by vertex: a half-edge that starts there
  std::vector<Triangle> triangles_;
  std::vector<LabelId> label_;  // by half-edge, invalid without; empty before the first
  predicates::PlaneFilter filter_;
  TriangleId last_;           // made last
  std::vector<SiteId> free_;  // removed vertices
  bool walls_ = false;
  bool stack_is_short_ = false;  // memory ended when an edge was to be pushed

  Conflict conflict_;              // scratch of insert()
  std::vector<HalfEdgeId> stack_;  // scratch of insert() and remove()
  std::vector<LabelId> touched_;
};

}  // namespace tetloft::internal::delaunay2_detail
