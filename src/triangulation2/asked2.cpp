// The API boundary: where points lie, which vertices are near them, and the triangulation as
// values.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/predicates.hpp>

#include "core/finite_points.hpp"
#include "core/guard.hpp"
#include "predicates/by_distance.hpp"
#include "triangulation2/behind_walls.hpp"
#include "triangulation2/edges_of_plane.hpp"
#include "triangulation2/handles2.hpp"

namespace tetloft {

using namespace internal;
using triangulation2::BehindWalls;
using triangulation2::EdgesOfPlane;
using triangulation2::Incremental2;
using triangulation2::LivePlane;
using triangulation2::SiteId;

namespace {

using ByDistance2 = predicates::ByDistance<EdgesOfPlane>;

Point3 raised(const Point2& p) { return {p.x, p.y, 0}; }

// The smallest simplex that holds a point, by its vertices; none outside.
struct Simplex2 {
  std::vector<VertexId> vertices;
  TriangleId triangle;
};

Simplex2 simplex_in_row(const LivePlane& plane, const Point2& p) {
  const std::vector<VertexId>& row = plane.row();
  const std::size_t at = plane.place_in_row(p);
  if (at < row.size() && plane.point(row[at]) == p) return {{row[at]}, {}};
  if (at == 0 || at == row.size()) return {};
  if (orient2d(plane.point(row[at - 1]), plane.point(row[at]), p) != Sign::zero) return {};
  return {{row[at - 1], row[at]}, {}};
}

Simplex2 simplex_of_plane(const LivePlane& plane, const Point2& p, VertexId near) {
  if (!plane.has_triangles()) return simplex_in_row(plane, p);
  const Incremental2& triangles = plane.triangles();
  const TriangleId t = triangles.locate(p, plane.start(p, near));
  if (triangles.is_ghost(t)) return {};
  const std::array<SiteId, 3>& v = triangles.vertices(t);
  Simplex2 result{{}, t};
  for (std::size_t i = 0; i < 3; ++i) {
    // Of the closed triangle that holds p: vertex i has no part in p iff p lies opposite it.
    if (orient2d(triangles.point(v[(i + 1) % 3]), triangles.point(v[(i + 2) % 3]), p) !=
        Sign::zero) {
      result.vertices.push_back(plane.vertex(v[i]));
    }
  }
  return result;
}

// Vertices near p: of the triangle that it lies in, or of the hull edge beyond which it lies.
std::vector<VertexId> vertices_near(const LivePlane& plane, const Point2& p, VertexId near) {
  std::vector<VertexId> result;
  if (!plane.has_triangles()) {
    const std::size_t at = plane.place_in_row(p);
    return {plane.row()[std::min(at, plane.row().size() - 1)]};
  }
  for (const SiteId s :
       plane.triangles().vertices(plane.triangles().locate(p, plane.start(p, near)))) {
    if (s != Incremental2::kGhost) result.push_back(plane.vertex(s));
  }
  return result;
}

// What `use` makes of the vertices in order of their distance from p.
template <class Use>
auto by_distance(const LivePlane& plane, const Point2& p, VertexId near, const Use& use) {
  if (plane.has_triangles() && !plane.walls().empty()) return use(BehindWalls(plane, p, near));
  return use(ByDistance2(EdgesOfPlane(plane), raised(p), vertices_near(plane, p, near)));
}

// `ask` of a triangulation that has points and a point that is finite; without points `nothing`.
template <class Answer, class Ask>
Result<Answer> asked_of_plane(const Point2& p, std::size_t vertices, const Answer& nothing,
                              const Ask& ask) {
  return guard_internal([&]() -> Result<Answer> {
    if (Result<void> fine = check_finite(p); !fine) return fine.error();
    if (vertices == 0) return nothing;
    return ask();
  });
}

}  // namespace

Result<Location2> DelaunayTriangulation2::locate(const Point2& point, DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of_plane<Location2>(point, vertex_count(), {}, [&] {
    Simplex2 found = simplex_of_plane(impl.plane, point, impl.hint(near));
    std::sort(found.vertices.begin(), found.vertices.end());
    constexpr std::array kinds{LocationKind::outside, LocationKind::vertex, LocationKind::edge,
                               LocationKind::facet};
    Location2 result;
    result.kind = kinds[found.vertices.size()];
    result.triangle = found.triangle;
    for (std::size_t i = 0; i < found.vertices.size(); ++i) {
      result.vertices[i] = impl.handle(found.vertices[i]);
    }
    return result;
  });
}

Result<DelaunayVertex> DelaunayTriangulation2::nearest_vertex(const Point2& point,
                                                              DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of_plane<DelaunayVertex>(point, vertex_count(), {}, [&] {
    return impl.handle(by_distance(impl.plane, point, impl.hint(near),
                                   [](auto nearest) { return nearest.first(); }));
  });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation2::nearest_vertices(
    const Point2& point, std::size_t k, DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of_plane<std::vector<DelaunayVertex>>(point, vertex_count(), {}, [&] {
    return by_distance(impl.plane, point, impl.hint(near), [&](auto nearest) {
      return impl.handles(predicates::first_of(nearest, k));
    });
  });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation2::vertices_within(
    const Point2& centre, double radius, DelaunayVertex near) const {
  if (!(radius >= 0)) {
    return Error{ErrorCode::invalid_input, "the radius is negative or not a number", {}};
  }
  const Impl& impl = get();
  return asked_of_plane<std::vector<DelaunayVertex>>(centre, vertex_count(), {}, [&] {
    return by_distance(impl.plane, centre, impl.hint(near), [&](auto nearest) {
      const auto point = [&](VertexId v) { return raised(impl.plane.point(v)); };
      return impl.handles(predicates::within(nearest, raised(centre), radius, point));
    });
  });
}

Result<ConflictZone2> DelaunayTriangulation2::conflict_zone(const Point2& point,
                                                            DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of_plane<ConflictZone2>(point, vertex_count(), {}, [&] {
    ConflictZone2 result;
    if (dimension() < 2) return result;
    const Incremental2& plane = impl.plane.triangles();
    const TriangleId at = plane.locate(point, impl.plane.start(point, impl.hint(near)));
    if (plane.vertex_at(point, at).valid()) return result;
    const Incremental2::Conflict conflict = plane.conflict(point, at);
    for (const TriangleId t : conflict.zone) {
      if (!plane.is_ghost(t)) result.triangles.push_back(t);
    }
    std::sort(result.triangles.begin(), result.triangles.end());
    // A turn that begins behind the ghost, if it is among them.
    std::vector<SiteId> turn;
    for (const Incremental2::HorizonEdge& edge : conflict.horizon) turn.push_back(edge.from);
    const auto lowest = [&](SiteId a, SiteId b) {
      return b != Incremental2::kGhost &&
             (a == Incremental2::kGhost || impl.plane.vertex(a) < impl.plane.vertex(b));
    };
    std::rotate(turn.begin(), std::min_element(turn.begin(), turn.end(), lowest), turn.end());
    const bool is_open = turn.front() == Incremental2::kGhost;
    if (is_open) turn.erase(turn.begin());
    for (const SiteId s : turn) result.neighbours.push_back(impl.handle(s));
    for (std::size_t i = 0; i + (is_open ? 1 : 0) < turn.size(); ++i) {
      result.horizon.push_back({result.neighbours[i], result.neighbours[(i + 1) % turn.size()]});
    }
    std::sort(result.neighbours.begin(), result.neighbours.end());
    return result;
  });
}

Result<DelaunaySnapshot2> DelaunayTriangulation2::snapshot(const Execution& execution) const {
  return guard_internal([&]() -> Result<DelaunaySnapshot2> {
    DelaunaySnapshot2 result;
    std::vector<Point2> points;
    for (const DelaunayVertex v : vertices()) {
      points.push_back(point(v));
      result.vertex.push_back(v);
    }
    // Unique, and numbered canonically.
    Result<Triangulation2> made = delaunay2(points, execution);
    if (!made) return made.error();
    result.triangulation = *std::move(made);
    result.dimension = dimension();
    return result;
  });
}

}  // namespace tetloft
