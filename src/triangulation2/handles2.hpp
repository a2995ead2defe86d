// What is behind a DelaunayTriangulation2: its points and triangles, and the handles of vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>

#include "core/finite_points.hpp"
#include "core/provide_room.hpp"
#include "core/vertex_places.hpp"
#include "triangulation2/live_plane.hpp"

namespace tetloft::internal::triangulation2 {

/// Of many at once, fewer than 2^29; the error names the first one that is not finite.
[[nodiscard]] inline Result<void> check_points(std::span<const Point2> points) {
  if (points.size() >= Incremental2::kMostVertices) {
    return Error{ErrorCode::invalid_input, "2^29 points or more", {}};
  }
  return check_all_finite(points);
}

}  // namespace tetloft::internal::triangulation2

class tetloft::DelaunayTriangulation2::Impl {
  using Incremental2 = internal::triangulation2::Incremental2;

 public:
  internal::triangulation2::LivePlane plane;
  internal::VertexPlaces places;
  // By constraint; invalid of those that are gone.
  IdVector<ConstraintId, std::array<VertexId, 2>> ends;
  std::size_t constraint_count = 0;

  [[nodiscard]] bool is_live(DelaunayVertex v) const {
    return places.is_latest(v) && plane.is_live(VertexId(v.index));
  }
  /// The place of a live vertex; throws std::out_of_range otherwise.
  [[nodiscard]] VertexId id(DelaunayVertex v) const {
    if (!is_live(v)) throw std::out_of_range("no such vertex");
    return VertexId(v.index);
  }
  /// Where a search is to start; invalid where v is none.
  [[nodiscard]] VertexId hint(DelaunayVertex v) const {
    return is_live(v) ? VertexId(v.index) : VertexId();
  }
  [[nodiscard]] DelaunayVertex handle(VertexId v) const { return places.handle(v.index()); }
  [[nodiscard]] std::vector<DelaunayVertex> handles(std::span<const VertexId> vertices) const {
    std::vector<DelaunayVertex> result;
    for (const VertexId v : vertices) result.push_back(handle(v));
    return result;
  }
  [[nodiscard]] DelaunayVertex handle(internal::triangulation2::SiteId s) const {
    return handle(plane.vertex(s));
  }
  [[nodiscard]] bool is_live(TriangleId t) const {
    return plane.has_triangles() && t.index() < plane.triangles().triangle_count() &&
           !plane.triangles().is_ghost(t);
  }
  /// Throws std::out_of_range where t is no triangle.
  void check(TriangleId t) const {
    if (!is_live(t)) throw std::out_of_range("no such triangle");
  }

  /// A place for a vertex at p, provided but not taken.
  [[nodiscard]] VertexId provide(const Point2& p) {
    const VertexId v(places.next(Incremental2::kMostVertices));
    plane.provide(v, p);
    return v;
  }
  Insertion insert(const Point2& p, VertexId near) {
    const VertexId v = provide(p);
    const VertexId found = plane.insert(v, near);
    if (found == v) places.take();
    return {handle(found), found == v};
  }
  void remove(VertexId v) {
    internal::provide_room(places.free, 1);
    plane.remove(v);
    places.release(v.index());
  }
  /// The first points there are; equal ones share a vertex. Returns that of each.
  std::vector<VertexId> take_all(std::span<const Point2> points, const Execution& execution) {
    places.generation.resize(points.size());
    std::vector<VertexId> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
      all.emplace_back(i);
      plane.provide(all.back(), points[i]);
    }
    std::vector<VertexId> vertex_of = plane.build(all, execution);
    for (std::size_t i = points.size(); i-- > 0;) {
      if (vertex_of[i] != all[i]) places.give_back(i);
    }
    return vertex_of;
  }
  /// The first points there are, by place, and those that have a vertex. False where two of these
  /// are equal.
  [[nodiscard]] bool take_vertices(std::span<const Point2> points,
                                   std::span<const std::uint32_t> live) {
    for (std::size_t i = 0; i < points.size(); ++i) plane.provide(VertexId(i), points[i]);
    const std::vector<VertexId> vertices(live.begin(), live.end());
    return live.empty() || plane.build(vertices, {.threads = 1}) == vertices;
  }
  /// What is said of a vertex that a constraint goes over, if one does.
  [[nodiscard]] Result<void> check_free(VertexId v) const {
    const internal::triangulation2::PlaneWall* wall = plane.wall_of(v);
    if (wall == nullptr) return {};
    Error error{ErrorCode::invalid_input,
                "constraint " + std::to_string(wall->lowest().value()) + " goes over the vertex",
                {}};
    error.where.vertex = v.index();
    return error;
  }

  // constraints2.cpp
  [[nodiscard]] bool is_live(ConstraintId c) const {
    return c.index() < ends.size() && ends[c][0].valid();
  }
  [[nodiscard]] Result<void> check_ends(const std::array<DelaunayVertex, 2>& segment) const;
  /// The vertices on the segment from u to v, in order; refused where it crosses a constraint.
  [[nodiscard]] Result<std::vector<VertexId>> path_between(VertexId u, VertexId v) const;
  /// A constraint comes to go over a path between two of its vertices.
  void lay(ConstraintId c, std::span<const VertexId> path);
  [[nodiscard]] Result<ConstraintId> constrain(VertexId u, VertexId v);
  // What these have done when they fail stays.
  [[nodiscard]] Result<ConstraintId> constrain_dividing(VertexId u, VertexId v);
  [[nodiscard]] Result<ConstraintId> constrain_one(const std::array<DelaunayVertex, 2>& segment,
                                                   Crossing crossing);
  /// False where one is refused.
  [[nodiscard]] bool constrain_in_any_order(
      std::span<const std::array<DelaunayVertex, 2>> segments);
  [[nodiscard]] Result<void> constrain_in_order(
      std::span<const std::array<DelaunayVertex, 2>> segments, Crossing crossing);
  [[nodiscard]] std::vector<std::array<VertexId, 2>> edges_of(ConstraintId c) const;

  /// Points one after the other, along a curve: each search starts at the last one.
  [[nodiscard]] std::vector<DelaunayVertex> insert_all(std::span<const Point2> points,
                                                       const Execution& execution);
};
