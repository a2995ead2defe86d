// The points of a plane that come and go, and their triangulation.
//
// Vertices are named by places, which the owner gives. Where points span the plane their triangles
// are an Incremental2's, which knows them as sites; where they are in a row, or one, or none, there
// is just that row, in canonical order.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "delaunay2/incremental.hpp"
#include "spatial/start_grid.hpp"
#include "triangulation2/walls_of_plane.hpp"

namespace tetloft::internal::triangulation2 {

using delaunay2_detail::HalfEdgeId;
using delaunay2_detail::Incremental2;
using delaunay2_detail::SiteId;

/// Ids are places.
class LivePlane {
 public:
  /// −1 without points, 0 of one, 1 of a row, 2.
  [[nodiscard]] int dimension() const;
  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }
  [[nodiscard]] bool is_live(VertexId v) const {
    return v.index() < site_of_.size() && site_of_[v].valid();
  }
  [[nodiscard]] const Point2& point(VertexId v) const { return points_[v]; }

  /// Where there are triangles. They are those of all live points.
  [[nodiscard]] bool has_triangles() const { return plane_.has_value(); }
  [[nodiscard]] const Incremental2& triangles() const { return *plane_; }
  [[nodiscard]] SiteId site(VertexId v) const { return site_of_[v]; }
  /// Invalid for the ghost.
  [[nodiscard]] VertexId vertex(SiteId s) const { return vertex_of_[s]; }
  /// Where there are none: all points, in canonical order.
  [[nodiscard]] const std::vector<VertexId>& row() const { return row_; }
  /// Where p is in the row, or would be.
  [[nodiscard]] std::size_t place_in_row(const Point2& p) const;

  /// A place, which no live vertex has, and the point that is to come there.
  void provide(VertexId place, const Point2& point);
  /// Makes what was provided a vertex; returns it, or the vertex that is at its point already. The
  /// search starts at `near` if that is live.
  VertexId insert(VertexId v, VertexId near);
  void remove(VertexId v);
  /// Vertex w, which is live, is v from now on, which is not.
  void rename(VertexId w, VertexId v);
  /// Triangulates points that were provided, instead of what there is. Of equal ones the first
  /// has the vertex: returns that of each.
  std::vector<VertexId> build(std::span<const VertexId> points, const Execution& execution);

  // Constraints, by edges. They are walls of the triangles.

  [[nodiscard]] const Walls& walls() const { return walls_; }
  /// A wall at v, or null.
  [[nodiscard]] const PlaneWall* wall_of(VertexId v) const;
  /// What one comes to on the way from a to another vertex b.
  struct Step {
    VertexId reached;                 ///< the first vertex on the segment
    std::array<VertexId, 2> crossed;  ///< the first wall that the segment crosses before, or none
  };
  [[nodiscard]] Step step(VertexId a, VertexId b) const;
  /// Constraints come to go over a b. Requires that a step leads from a to b, without a wall.
  void add_to_edge(VertexId a, VertexId b, std::span<const ConstraintId> over);
  /// A constraint goes over a b no more. Requires that it does, maybe several times.
  void take_from_edge(VertexId a, VertexId b, ConstraintId c);
  /// The edge a b is no wall any more. Returns what went over it.
  std::vector<ConstraintId> open_edge(VertexId a, VertexId b);

  /// The site to start a search for p at. Requires triangles.
  [[nodiscard]] SiteId start(const Point2& p, VertexId near) const;

 private:
  VertexId insert_into_row(VertexId v);
  [[nodiscard]] bool is_in_row(const Point2& p) const;
  [[nodiscard]] bool spans_plane_without(VertexId v) const;
  [[nodiscard]] std::vector<VertexId> live_vertices() const;
  void note_start(VertexId v);
  [[nodiscard]] Walls::Division division_of(SiteId near, VertexId v);

  // By place.
  IdVector<VertexId, Point2> points_;
  // Valid of live vertices; the ghost's of those in the row.
  IdVector<VertexId, SiteId> site_of_;

  std::optional<Incremental2> plane_;
  IdVector<SiteId, VertexId> vertex_of_;  // invalid for the ghost and removed sites
  std::vector<VertexId> row_;             // empty where there are triangles
  StartGrid starts_;                      // where there are triangles
  Walls walls_;
  std::size_t vertex_count_ = 0;
};

}  // namespace tetloft::internal::triangulation2
