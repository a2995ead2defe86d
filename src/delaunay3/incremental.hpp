// Incremental 3D Delaunay triangulation: locate, collect the conflict zone, star the
// cavity (Bowyer, "Computing Dirichlet tessellations", and Watson, "Computing the
// n-dimensional Delaunay tessellation", The Computer Journal 24, 1981).
//
// Invariant between insertions: the live tets are the Delaunay triangulation, under the
// symbolic perturbation of insphere_perturbed, of the vertices inserted so far, closed by
// ghost tets: each facet of the convex hull is joined to the ghost vertex, a point at
// infinity. Combinatorially the tets form a 3-sphere, so every face has two tets and no
// traversal has a boundary branch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/canonical_mesh.hpp"
#include "predicates/set_filter.hpp"

namespace tetloft::delaunay3_detail {

/// The vertex at infinity. In a ghost tet it is vertex 0, always.
inline constexpr VertexId kGhost{0xFFFFFFFEU};

class Delaunay3Builder {
 public:
  /// Vertex i is points[i]. Requires: distinct finite points; the first four are affinely
  /// independent; fewer than 2^30 points.
  explicit Delaunay3Builder(IdVector<VertexId, Point3> points);

  /// Inserts all vertices in order, once. Returns false, leaving the triangulation without the
  /// vertices from there on, where it would take 2^30 tet slots or more.
  [[nodiscard]] bool insert_all();

  /// All slots: of ghost tets vertex 0 is kGhost, of dead ones it is invalid. Valid after
  /// insert_all().
  [[nodiscard]] TetArrays arrays() const { return {tets_.raw(), opposite_.raw()}; }

 private:
  // A facet of the horizon, the boundary of the conflict zone: its half-face in the tet
  // that stays and in the tet that goes, and the tet that will join it to the new vertex.
  struct HorizonFacet {
    HalfFaceId outer;
    HalfFaceId inner;
    TetId filler;
  };

  void make_first_tets();
  // Adds vertex v near hint_. False when out of slots, nothing changed.
  bool insert(VertexId v);
  // A tet whose closure contains p, or a ghost tet whose hull facet p lies strictly
  // beyond: in either case one that is in conflict with p.
  TetId locate(const Point3& p, TetId start);
  // Fills conflict_ and horizon_; marks the conflict zone with the current epoch.
  void collect_conflict_zone(const Point3& p, TetId start);
  // Replaces the conflict zone by the tets that join the horizon to v. Returns one of
  // them, finite.
  TetId star_cavity(VertexId v);

  [[nodiscard]] bool in_conflict(TetId t, const Point3& p) const;
  [[nodiscard]] bool in_ghost_conflict(TetId t, const Point3& p) const;
  [[nodiscard]] bool in_sphere(const TetVertices& tet, const Point3& p) const;
  // Does p lie strictly beyond face i of the tet?
  [[nodiscard]] bool is_beyond(const TetVertices& tet, std::size_t i, const Point3& p) const;

  // Gives every facet of the horizon its filler, glued to the outer tet only.
  void create_fillers(VertexId v);
  // Glues each two fillers that share an edge of the horizon.
  void glue_fillers();
  // The face of the filler across face i of `facet`'s filler.
  [[nodiscard]] HalfFaceId filler_across(const HorizonFacet& facet, std::size_t i) const;
  TetId new_tet(const TetVertices& vertices);
  void glue(HalfFaceId a, HalfFaceId b) {
    opposite_[a] = b;
    opposite_[b] = a;
  }

  [[nodiscard]] bool is_ghost(TetId t) const { return tets_[t][0] == kGhost; }
  // Marks of the current insertion: in or out of the conflict zone; anything else is older
  // and means not visited.
  [[nodiscard]] std::uint32_t mark_in() const { return 2 * epoch_ + 1; }
  [[nodiscard]] std::uint32_t mark_out() const { return 2 * epoch_; }

  IdVector<VertexId, Point3> points_;
  predicates::SetFilter filter_;
  // Positive; ghost tets would be with the ghost far beyond their hull facet. [3] is the
  // latest vertex. [0] is kGhost in ghost tets, invalid in dead slots after insert_all().
  IdVector<TetId, TetVertices> tets_;
  // opposite_[4 t + i]; valid in every live tet.
  IdVector<HalfFaceId, HalfFaceId> opposite_;
  // Epoch stamps: mark_in() or mark_out() of the insertion that last visited the tet.
  IdVector<TetId, std::uint32_t> mark_;
  std::uint32_t epoch_ = 0;
  // Dead slots, last freed last.
  std::vector<TetId> free_;
  // A live finite tet where the next walk starts.
  TetId hint_;
  // State of the walk's linear congruential generator.
  std::uint32_t walk_state_ = 1;

  // Scratch of one insertion.
  std::vector<TetId> conflict_;
  std::vector<HorizonFacet> horizon_;
};

}  // namespace tetloft::delaunay3_detail
