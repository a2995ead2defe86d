// Volumes of all whole cells, tet by tet (flag_volumes.hpp).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tetloft/voronoi.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"
#include "voronoi/flag_volumes.hpp"
#include "voronoi/moderate.hpp"
#include "voronoi/sites.hpp"

namespace tetloft {

using namespace internal;

namespace {

std::array<double, 4> shares_of(const std::array<Point3, 4>& p) {
  std::array<double, 4> shares{};
  voronoi::for_each_corner(p, [&](std::size_t i, const voronoi::CornerOfTet& corner, int exponent) {
    shares[i] = std::ldexp(voronoi::flag_volume(corner), 3 * exponent);
  });
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
