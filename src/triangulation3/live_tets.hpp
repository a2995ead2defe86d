// The tets of a triangulation that changes, whatever the dimension of its points.
//
// Invariant between changes: the live tets are the Delaunay triangulation, under the symbolic
// perturbation, of the live vertices, closed by ghost tets (delaunay3/growing_tets.hpp); of each
// live vertex one of its tets is known.
//
// Points that span no space are lifted out of their plane or line, or off their place, by auxiliary
// vertices: as many as dimensions are missing, none of them in the affine hull of the points and
// the others. All tets have them all then, and what these leave of the tets is the triangulation of
// the plane or line: the sphere of a triangle and an auxiliary vertex meets the plane in the
// triangle's circle, and the perturbed in-sphere predicate is the perturbed in-circle one, as the
// cofactor of the auxiliary vertex's lift is the orientation of four coplanar points. So there is
// one engine for all dimensions; where the dimension changes, all is built anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "delaunay3/growing_tets.hpp"
#include "delaunay3/insertion.hpp"
#include "spatial/start_grid.hpp"
#include "triangulation3/hole.hpp"

namespace tetloft::internal::triangulation3 {

using delaunay3_detail::GrowingTets;
using delaunay3_detail::half_face;
using delaunay3_detail::index_of;
using delaunay3_detail::Inserter;
using delaunay3_detail::kGhost;
using delaunay3_detail::TetSlot;

class LiveTets {
 public:
  /// Vertices below are auxiliary, whether there are any or not.
  static constexpr std::size_t kAuxiliaries = 3;

  LiveTets();
  LiveTets(const LiveTets& other);
  LiveTets& operator=(const LiveTets&) = delete;

  // What is there.

  /// Of the points: −1 without.
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
  /// Places of vertices, auxiliary and free ones included.
  [[nodiscard]] std::size_t vertex_slots() const { return tet_of_.size(); }
  [[nodiscard]] bool is_live(VertexId v) const {
    return v.index() < tet_of_.size() && tet_of_[v].valid();
  }
  [[nodiscard]] static bool is_point(VertexId v) {
    return v != kGhost && v.index() >= kAuxiliaries;
  }
  [[nodiscard]] const Point3& point(VertexId v) const { return tets_.point(v); }
  [[nodiscard]] const GrowingTets& tets() const { return tets_; }
  [[nodiscard]] std::size_t tet_slots() const { return tets_.taken(); }
  [[nodiscard]] bool is_live(TetId t) const {
    return t.index() < tets_.taken() && tets_.tet(t)[0].valid();
  }
  [[nodiscard]] bool is_finite(TetId t) const { return is_live(t) && !tets_.is_ghost(t); }
  /// Finite ones; 0 where points span no space.
  [[nodiscard]] std::size_t tet_count() const { return dimension_ < 3 ? 0 : finite_tets_; }
  /// A tet of a live vertex, perhaps a ghost.
  [[nodiscard]] TetId tet_of(VertexId v) const { return tet_of_[v]; }

  // Changes. Where they throw, everything is as it was.

  /// Room for so many vertices, auxiliary ones apart.
  void reserve(std::size_t vertices);
  /// A place for a vertex that is in no tet yet; `place` is one that is free, or vertex_slots().
  void provide(VertexId place, const Point3& point);
  /// The vertex at the point of v, which was provided: v itself, inserted now, or another one.
  [[nodiscard]] VertexId insert(VertexId v, VertexId near);
  void remove(VertexId v);
  /// v, which is free, takes the place of w in the triangulation.
  void rename(VertexId w, VertexId v);
  /// All of these vertices, which were provided and are distinct, and no others, at once.
  void build(std::span<const VertexId> points, const Execution& execution);

  // Questions.

  /// Where the search for a point starts, a finite tet: at `near` if that is live, or somewhere
  /// good. Requires points.
  [[nodiscard]] TetId start(const Point3& p, VertexId near) const;
  /// A tet whose closure contains p, or a ghost tet beyond whose hull facet it lies strictly.
  /// Requires points.
  [[nodiscard]] TetId locate(const Point3& p, VertexId near) const;
  /// Is p in the affine hull of the points?
  [[nodiscard]] bool spans(const Point3& p) const;

 private:
  [[nodiscard]] TetId finite(TetId t) const {
    return tets_.is_ghost(t) ? TetMesh::tet_of(tets_.opposite(half_face(t, 0))) : t;
  }
  [[nodiscard]] std::vector<VertexId> live_points() const;
  // Of the vertex whose hole is open.
  [[nodiscard]] bool keeps_dimension_without_open() const;
  void note_inserted(VertexId v);
  [[nodiscard]] std::size_t count_finite(std::span<const TetId> tets) const;
  void renew_starts();
  [[nodiscard]] predicates::SetFilter filter_of_all(std::span<const Point3> auxiliaries) const;

  GrowingTets tets_;
  Inserter inserter_;
  Hole hole_;
  StartGrid starts_;
  // A tet of each live vertex; invalid where there is none.
  IdVector<VertexId, TetId> tet_of_;
  std::size_t vertex_count_ = 0;
  std::size_t finite_tets_ = 0;
  int dimension_ = -1;
};

}  // namespace tetloft::internal::triangulation3
