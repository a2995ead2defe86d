#include "voronoi/dual_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/vector.hpp"
#include "voronoi/circumcentre3.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/polygon_area.hpp"

namespace tetloft::internal::voronoi {

using namespace vectors;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The centre of a tet's sphere relative to one of its vertices.
Point3 centre_from(const DelaunayTriangulation3& triangulation, TetId t, DelaunayVertex site) {
  std::array<DelaunayVertex, 4> v = triangulation.vertices(t);
  std::iter_swap(v.begin(), std::find(v.begin(), v.end(), site));
  return circumcentre_from(triangulation.point(v[0]), triangulation.point(v[1]),
                           triangulation.point(v[2]), triangulation.point(v[3]));
}

// Puts the tets around u → v in the order in which they come counter-clockwise as seen from beyond
// v. Where the first is u, v, x, y, positive, the next one is across the face opposite x, which
// runs u, v, y as seen from outside.
void turn_counter_clockwise(const DelaunayTriangulation3& triangulation, DelaunayVertex u,
                            DelaunayVertex v, std::vector<TetId>& ring) {
  if (ring.size() < 2) return;
  for (int i = 0; i < 4; ++i) {
    const HalfFaceId h = TetMesh::half_face(ring[0], i);
    const std::array<DelaunayVertex, 3> face = triangulation.vertices(h);
    const auto at = static_cast<std::size_t>(std::find(face.begin(), face.end(), u) - face.begin());
    if (at == 3 || face[(at + 1) % 3] != v) continue;
    const HalfFaceId across = triangulation.opposite(h);
    if (!across.valid() || TetMesh::tet_of(across) != ring[1]) {
      std::reverse(ring.begin(), ring.end());
    }
    return;
  }
}

double area_of(const std::vector<std::uint32_t>& corners, const std::vector<Point3>& at,
               const Point3& normal) {
  const Point3 twice = twice_area(corners, [&](std::uint32_t i) -> const Point3& { return at[i]; });
  return std::max(0.0, 0.5 * dot(twice, normal));
}

}  // namespace

VoronoiCell3 dual_cell(const DelaunayTriangulation3& triangulation, DelaunayVertex site,
                       const std::vector<DelaunayVertex>& neighbours) {
  const bool spans_space = triangulation.dimension() == 3;
  const Point3& at = triangulation.point(site);
  VoronoiCell3 cell;
  cell.site = site;
  cell.bounded = spans_space && !triangulation.is_on_hull(site);
  const std::vector<TetId> star =
      spans_space ? triangulation.star(site) : std::vector<TetId>();  // by id
  for (const TetId t : star) cell.corners.push_back(centre_from(triangulation, t, site));
  for (const DelaunayVertex v : neighbours) {
    VoronoiFace3 face;
    face.neighbour = v;
    EdgeRing ring = spans_space ? triangulation.ring(site, v) : EdgeRing();
    turn_counter_clockwise(triangulation, site, v, ring.tets);
    for (const TetId t : ring.tets) {
      const auto place = std::lower_bound(star.begin(), star.end(), t);
      face.corners.push_back(static_cast<std::uint32_t>(place - star.begin()));
    }
    face.bounded = ring.closed;
    const HalfSpace half_space = nearer_to_origin(triangulation.point(v) - at);
    face.area = face.bounded ? area_of(face.corners, cell.corners, half_space.normal) : kInfinite;
    cell.volume += half_space.offset * face.area / 3;
    cell.faces.push_back(std::move(face));
  }
  if (!cell.bounded) cell.volume = kInfinite;
  for (Point3& corner : cell.corners) corner = corner + at;
  return cell;
}

}  // namespace tetloft::internal::voronoi
