// Volumes of all whole cells, tet by tet.
//
// A cell is the signed sum, over the flags vertex, edge, facet, tet at its site, of orthoschemes:
// the site, the edge's midpoint, the facet's circumcentre and the tet's. Each is a sixth of the
// product of three lengths at right angles: half the edge; from there to the facet's centre,
// negative where the third vertex is on the other side; from there to the tet's centre, likewise
// with the fourth. What sticks out of the cell is taken away by another flag. So every tet is
// looked at once, in coordinates of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tetloft/voronoi.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/vector.hpp"
#include "core/watched_work.hpp"
#include "voronoi/circumcentre3.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/near_one.hpp"
#include "voronoi/sites.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The part of a vertex' cell in a tet: by the edges from there to the other vertices, and the
// centre.
double share_of(const std::array<Point3, 3>& edge, const Point3& centre) {
  using namespace vectors;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = edge[k];
    const Point3& q = edge[(k + 1) % 3];
    const Point3 normal = cross(p, q);
    // Distance to the facet's plane times twice its area: positive on the fourth vertex' side.
    const bool turned = dot(edge[(k + 2) % 3], normal) < 0;
    const double height = turned ? -dot(centre, normal) : dot(centre, normal);
    // In the facet the distance of its centre from p is half |p| times the cotangent of the angle
    // opposite, that of its inner product and twice the area; from q likewise.
    const double of_edges = dot(p, p) * dot(q, q - p) + dot(q, q) * dot(p, p - q);
    sum += height * of_edges / (24 * dot(normal, normal));
  }
  return sum;
}

std::array<double, 4> shares_of(std::array<Point3, 4> p) {
  using namespace vectors;
  const int exponent = voronoi::bring_near_one(p, voronoi::largest_difference(p));
  const Point3 centre = voronoi::circumcentre_from(p[0], p[1], p[2], p[3]);
  std::array<double, 4> shares{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array<Point3, 3> edge{p[(i + 1) % 4] - p[i], p[(i + 2) % 4] - p[i],
                                     p[(i + 3) % 4] - p[i]};
    shares[i] = std::ldexp(share_of(edge, centre - (p[i] - p[0])), 3 * exponent);
  }
  return shares;
}

std::vector<double> volumes_of(const DelaunayTriangulation3& triangulation,
                               const Execution& execution) {
  constexpr std::size_t kStretch = 1024;
  const std::size_t slots = triangulation.tet_slots();
  const std::size_t stretches = (slots + kStretch - 1) / kStretch;
  std::vector<std::array<double, 4>> share(slots);
  WatchedWork work(execution, stretches + 1);
  work.go_on();
  parallel_for(stretches, execution.threads, [&](std::size_t stretch) {
    const std::size_t end = std::min(slots, (stretch + 1) * kStretch);
    for (std::size_t slot = stretch * kStretch; slot < end; ++slot) {
      const TetId t = triangulation.tet_at(slot);
      if (!t.valid()) continue;
      const std::array<DelaunayVertex, 4> v = triangulation.vertices(t);
      share[slot] = shares_of({triangulation.point(v[0]), triangulation.point(v[1]),
                               triangulation.point(v[2]), triangulation.point(v[3])});
    }
    work.step_done_go_on();
  });
  std::vector<double> volume(triangulation.vertex_slots());
  std::vector<std::uint8_t> is_unbounded(volume.size());
  for (const TetId t : triangulation.tets()) {
    const std::array<DelaunayVertex, 4> v = triangulation.vertices(t);
    for (std::size_t i = 0; i < 4; ++i) {
      volume[v[i].index] += share[t.index()][i];
      if (triangulation.opposite(TetMesh::half_face(t, static_cast<int>(i))).valid()) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        if (k != i) is_unbounded[v[k].index] = 1;
      }
    }
  }
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const DelaunayVertex v : triangulation.vertices()) {
    if (triangulation.dimension() < 3 || is_unbounded[v.index] != 0) volume[v.index] = kInfinite;
  }
  work.step_done();
  return volume;
}

}  // namespace

Result<std::vector<double>> voronoi_volumes(const DelaunayTriangulation3& triangulation,
                                            const Execution& execution) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<double>> {
    for (const DelaunayVertex v : triangulation.vertices()) {
      if (voronoi::is_moderate(triangulation.point(v))) continue;
      Error error = voronoi::immoderate_site(v);
      error.where.point = triangulation.point(v);
      return error;
    }
    return volumes_of(triangulation, own);
  });
}

}  // namespace tetloft
