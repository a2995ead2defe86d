// Incremental 3D Delaunay triangulation: locate, collect the conflict zone, star the
// cavity (Bowyer, "Computing Dirichlet tessellations", and Watson, "Computing the
// n-dimensional Delaunay tessellation", The Computer Journal 24, 1981).
//
// Invariant between insertions: the live tets are the Delaunay triangulation, under the
// symbolic perturbation of insphere_perturbed, of the vertices inserted so far, closed by
// ghost tets: each facet of the convex hull is joined to the ghost vertex, a point at
// infinity. Combinatorially the tets form a 3-sphere, so every face has two tets and no
// traversal has a boundary branch.
//
// Memory is laid out for the search of the conflict zone, which is most of the work: a tet's
// vertices and neighbours share a cache line (half of one), so do a point and its number on
// the horizon.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

#include "core/watched_work.hpp"
#include "delaunay3/tet_slot.hpp"
#include "predicates/set_filter.hpp"

namespace tetloft::internal::delaunay3_detail {

/// The vertex at infinity. In a ghost tet it is vertex 0, always.
inline constexpr VertexId kGhost{0xFFFFFFFEU};

class Delaunay3Builder {
 public:
  static constexpr std::size_t kPointsOfStep = 1024;

  /// Vertex i is points[i]. Requires: distinct finite points; the first four are affinely
  /// independent; fewer than 2^30 points.
  explicit Delaunay3Builder(IdVector<VertexId, Point3> points);

  /// Inserts all vertices in order, once. Returns false, leaving the triangulation without the
  /// vertices from there on, where it would take more than `most_tets` slots, ghost tets
  /// included; these are fewer than 2^30, since half-faces are 4 t + i in 32 bits. Tells a step
  /// for every kPointsOfStep vertices.
  [[nodiscard]] bool insert_all(WatchedWork& work,
                                std::size_t most_tets = (std::size_t{1} << 30) - 1);

  /// All slots: of ghost tets vertex 0 is kGhost, of dead ones it is invalid. Valid after
  /// insert_all().
  [[nodiscard]] std::span<TetSlot> slots() { return slots_; }

 private:
  // A facet of the horizon, the boundary of the conflict zone: its half-face in the tet
  // that stays and in the tet that goes, and the tet that will join it to the new vertex.
  struct HorizonFacet {
    HalfFaceId outer;
    HalfFaceId inner;
    TetId filler;
  };

  // A point, and the number of its vertex among those of the current horizon. That number is
  // a guess left by some earlier insertion wherever horizon_vertices_ does not confirm it, so
  // that nothing needs to be cleared.
  struct Vertex {
    Point3 point;
    std::uint32_t on_horizon = 0;
  };

  // What the current insertion knows of a tet. Between insertions all are unvisited. A visited
  // one has 2 − (whether it is in conflict).
  enum class Mark : std::uint8_t { unvisited = 0, in_conflict = 1, outside = 2 };

  // Cavities whose horizon has fewer vertices than this, the ghost apart, are glued by a table
  // of its edges; a uniform set has 15.5 on average.
  static constexpr std::size_t kTableSide = 64;
  // For so many tets of a zone, and facets of its horizon, there is room from the start.
  static constexpr std::size_t kRoom = 64;

  void make_first_tets();
  // Adds vertex v near hint_. False when out of slots, nothing changed.
  bool insert(VertexId v);
  // A tet whose closure contains p, or a ghost tet whose hull facet p lies strictly
  // beyond: in either case one that is in conflict with p.
  TetId locate(const Point3& p, TetId start);
  // Fills conflict_ and horizon_, and marks their tets.
  void collect_conflict_zone(const Point3& p, TetId start);
  void fetch_neighbours(TetId t) const;
  // Replaces the conflict zone by the tets that join the horizon to v. Returns one of
  // them, finite.
  TetId star_cavity(VertexId v);

  [[nodiscard]] bool in_conflict(TetId t, const Point3& p) const;
  [[nodiscard]] bool in_ghost_conflict(TetId t, const Point3& p) const;
  [[nodiscard]] bool in_sphere(const TetVertices& tet, const Point3& p) const;
  // As orient3d; for points of the set only.
  [[nodiscard]] Sign orientation(const Point3& a, const Point3& b, const Point3& c,
                                 const Point3& d) const;
  // Does p lie strictly beyond face i of the tet?
  [[nodiscard]] bool is_beyond(const TetVertices& tet, std::size_t i, const Point3& p) const;

  // Gives every facet of the horizon its filler, glued to the outer tet only.
  void create_fillers(VertexId v);
  // The number of vertex v of the horizon, a new one where it has none. Sets table_is_full_
  // where there is none left.
  std::size_t number_on_horizon(VertexId v);
  // Glues each two fillers that share an edge of the horizon: by looking edges up in the
  // table that create_fillers() filled, or, where the horizon has too many vertices for it,
  // by turning around the edges through the conflict zone.
  void glue_fillers();
  void glue_fillers_by_table();
  void glue_fillers_by_turning();
  // The face of the filler across face i of `facet`'s filler.
  [[nodiscard]] HalfFaceId filler_across(const HorizonFacet& facet, std::size_t i) const;
  // Takes a slot for every facet of the horizon.
  void take_slots();
  void glue(HalfFaceId a, HalfFaceId b) {
    opposite(a) = b;
    opposite(b) = a;
  }

  [[nodiscard]] bool is_ghost(TetId t) const { return tet(t)[0] == kGhost; }
  [[nodiscard]] const TetVertices& tet(TetId t) const { return slots_[t.index()].vertices; }
  [[nodiscard]] HalfFaceId& opposite(HalfFaceId h) {
    return slots_[h.index() >> 2].opposite[h.index() & 3];
  }
  [[nodiscard]] HalfFaceId opposite(HalfFaceId h) const {
    return slots_[h.index() >> 2].opposite[h.index() & 3];
  }
  [[nodiscard]] const Point3& point(VertexId v) const { return vertices_[v.index()].point; }
  [[nodiscard]] Mark& mark(TetId t) { return marks_[t.index()]; }
  [[nodiscard]] Mark mark(TetId t) const { return marks_[t.index()]; }

  std::vector<Vertex> vertices_;
  predicates::SetFilter filter_;
  // Positive; ghost tets would be with the ghost far beyond their hull facet. [3] is the
  // latest vertex. [0] is kGhost in ghost tets, invalid in dead slots after insert_all().
  std::vector<TetSlot> slots_;
  // Apart from the slots: one cache line of marks answers for many tets that were made
  // together, most of them visited before.
  std::vector<Mark> marks_;
  // Dead slots, last freed last.
  std::vector<TetId> free_;
  std::size_t most_tets_ = 0;
  // A live finite tet where the next walk starts.
  TetId hint_;
  // State of the walk's linear congruential generator.
  std::uint32_t walk_state_ = 1;

  // Scratch of one insertion.
  std::vector<TetId> conflict_;
  std::vector<HorizonFacet> horizon_;
  // The vertices of the horizon by number, the ghost apart.
  std::array<VertexId, kTableSide> horizon_vertices_;
  std::size_t horizon_vertex_count_ = 0;
  bool table_is_full_ = false;
  // edge_table_[kTableSide * a + b]: the half-face of a filler on the horizon's edge from the
  // vertex of number a to that of number b. Old entries remain: every edge of the horizon is
  // written, in both directions, before one is read.
  std::vector<HalfFaceId> edge_table_;
};

}  // namespace tetloft::internal::delaunay3_detail
