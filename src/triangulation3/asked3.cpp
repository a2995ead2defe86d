// The API boundary: where points lie, which vertices are near them, and the triangulation as
// values.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <tetloft/delaunay3.hpp>
#include <tetloft/delaunay_triangulation3.hpp>

#include "core/finite_points.hpp"
#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "triangulation3/handles3.hpp"
#include "triangulation3/nearest.hpp"
#include "triangulation3/questions3.hpp"

namespace tetloft {

using namespace internal;
using triangulation3::LiveTets;
using triangulation3::Nearest;

namespace {

LocationKind kind_of(std::size_t vertices) {
  constexpr std::array kinds{LocationKind::outside, LocationKind::vertex, LocationKind::edge,
                             LocationKind::facet, LocationKind::tet};
  return kinds[vertices];
}

// `ask` of a triangulation that has points and a point that is finite; without points `nothing`.
template <class Answer, class Ask>
Result<Answer> asked_of(const Point3& p, std::size_t vertices, const Answer& nothing,
                        const Ask& ask) {
  return guard_internal([&]() -> Result<Answer> {
    if (Result<void> fine = check_finite(p); !fine) return fine.error();
    if (vertices == 0) return nothing;
    return ask();
  });
}

}  // namespace

Location3 DelaunayTriangulation3::Impl::location(const Point3& p, VertexId near) const {
  triangulation3::Simplex found = triangulation3::simplex_at(tets, p, near);
  std::sort(found.vertices.begin(), found.vertices.end());
  Location3 result;
  result.kind = kind_of(found.vertices.size());
  for (std::size_t i = 0; i < found.vertices.size(); ++i) {
    result.vertices[i] = handle(found.vertices[i]);
  }
  if (tets.dimension() == 3) result.tet = found.tet;
  return result;
}

Result<Location3> DelaunayTriangulation3::locate(const Point3& point, DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of<Location3>(point, vertex_count(), {},
                             [&] { return impl.location(point, impl.hint(near)); });
}

Result<DelaunayVertex> DelaunayTriangulation3::nearest_vertex(const Point3& point,
                                                              DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of<DelaunayVertex>(point, vertex_count(), {}, [&] {
    return impl.handle(Nearest(impl.tets, point, impl.hint(near)).first());
  });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation3::nearest_vertices(
    const Point3& point, std::size_t k, DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of<std::vector<DelaunayVertex>>(point, vertex_count(), {}, [&] {
    Nearest nearest(impl.tets, point, impl.hint(near));
    return impl.handles(predicates::first_of(nearest, k));
  });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation3::vertices_within(
    const Point3& centre, double radius, DelaunayVertex near) const {
  if (!(radius >= 0)) {
    return Error{ErrorCode::invalid_input, "the radius is negative or not a number", {}};
  }
  const Impl& impl = get();
  return asked_of<std::vector<DelaunayVertex>>(centre, vertex_count(), {}, [&] {
    Nearest nearest(impl.tets, centre, impl.hint(near));
    const auto point = [&](VertexId v) { return impl.tets.point(v); };
    return impl.handles(predicates::within(nearest, centre, radius, point));
  });
}

Result<ConflictZone3> DelaunayTriangulation3::conflict_zone(const Point3& point,
                                                            DelaunayVertex near) const {
  const Impl& impl = get();
  return asked_of<ConflictZone3>(point, vertex_count(), {}, [&] {
    ConflictZone3 result;
    const VertexId hint = impl.hint(near);
    if (dimension() < 3 || triangulation3::simplex_at(impl.tets, point, hint).vertices.size() == 1)
      return result;
    const auto& tets = impl.tets.tets();
    std::vector<TetId> zone = triangulation3::zone_of(impl.tets, point, hint);
    std::sort(zone.begin(), zone.end());
    std::vector<VertexId> corners;
    for (const TetId t : zone) {
      const bool is_ghost = tets.is_ghost(t);
      if (!is_ghost) result.tets.push_back(t);
      for (std::size_t i = is_ghost ? 1 : 0; i < 4; ++i) corners.push_back(tets.tet(t)[i]);
      for (std::size_t i = 0; i < (is_ghost ? std::size_t{1} : std::size_t{4}); ++i) {
        const HalfFaceId h = triangulation3::half_face(t, i);
        const HalfFaceId across = tets.opposite(h);
        if (std::binary_search(zone.begin(), zone.end(), TetMesh::tet_of(across))) continue;
        result.horizon.push_back(is_ghost ? across : h);
      }
    }
    std::sort(result.horizon.begin(), result.horizon.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    result.neighbours = impl.handles(corners);
    return result;
  });
}

Result<DelaunaySnapshot3> DelaunayTriangulation3::snapshot(const Execution& execution) const {
  return guard_internal([&]() -> Result<DelaunaySnapshot3> {
    DelaunaySnapshot3 result;
    for (const DelaunayVertex v : vertices()) {
      result.points.push_back(point(v));
      result.vertex.push_back(v);
    }
    // Unique, and numbered canonically.
    Result<Delaunay3> made = delaunay3(result.points.raw(), {.execution = execution});
    if (!made) return made.error();
    result.mesh = std::move(made->mesh);
    result.dimension = made->dimension;
    return result;
  });
}

}  // namespace tetloft
