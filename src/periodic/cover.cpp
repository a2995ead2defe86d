#include "periodic/cover.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>

#include <tetloft/delaunay3.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/vector.hpp"
#include "core/watched_work.hpp"
#include "voronoi/circumcentre3.hpp"

namespace tetloft::internal::periodic {

using namespace vectors;

namespace {

// Beyond takes minutes: of one point in a box 200 times as long as wide, say.
double most_images(std::size_t points) {
  return std::min(0x1p26, 0x1p17 + 0x1p11 * static_cast<double>(points));
}
// Images are taken by so much more, in coordinates and of them, than is relied on: far more than
// wrapping takes, 2^-26, and rounding of coordinates, some 2^16 units of the last place.
constexpr double kSlack = 0x1p-20;

// From where to where coordinates of the region reach that is covered with this margin.
struct Region {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
};
Region region_around(const Lattice& lattice, double margin) {
  Region region;
  for (std::size_t i = 0; i < 3; ++i) {
    region.low[i] = -margin * lattice.slope[i];
    region.high[i] = 1 - region.low[i];
  }
  return region;
}
Region widened(Region region) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double by = kSlack * (region.high[i] - region.low[i]);
    region.low[i] -= by;
    region.high[i] += by;
  }
  return region;
}

double expected_images(const Region& region, std::size_t points) {
  double expected = static_cast<double>(points);
  for (std::size_t i = 0; i < 3; ++i) expected *= region.high[i] - region.low[i];
  return expected;
}

void add_images(const Lattice& lattice, const Region& region,
                const std::vector<std::array<double, 3>>& at, Cover& cover) {
  std::array<std::int32_t, 3> first{}, last{};
  for (std::size_t i = 0; i < 3; ++i) {
    first[i] = static_cast<std::int32_t>(std::floor(region.low[i])) - 1;
    last[i] = static_cast<std::int32_t>(std::ceil(region.high[i]));
  }
  std::array<std::int32_t, 3> s{};
  for (s[0] = first[0]; s[0] <= last[0]; ++s[0]) {
    for (s[1] = first[1]; s[1] <= last[1]; ++s[1]) {
      for (s[2] = first[2]; s[2] <= last[2]; ++s[2]) {
        if (s == std::array<std::int32_t, 3>{}) continue;
        const Point3 by = static_cast<double>(s[0]) * lattice.basis[0] +
                          static_cast<double>(s[1]) * lattice.basis[1] +
                          static_cast<double>(s[2]) * lattice.basis[2];  // exact
        for (std::size_t v = 0; v < cover.in_cell; ++v) {
          bool inside = true;
          for (std::size_t i = 0; i < 3; ++i) {
            const double x = at[v][i] + s[i];
            inside = inside && x >= region.low[i] && x <= region.high[i];
          }
          if (!inside) continue;
          cover.points.push_back(cover.points[v] + by);
          cover.point_of.push_back(static_cast<std::uint32_t>(v));
          cover.shift.push_back(s);
        }
      }
    }
  }
}

Cover images(const Lattice& lattice, const WrappedPoints& wrapped, const Region& region) {
  Cover cover;
  cover.in_cell = wrapped.points.size();
  cover.points = wrapped.points;
  std::vector<std::array<double, 3>> at;
  for (std::size_t v = 0; v < cover.in_cell; ++v) {
    at.push_back(coordinates(lattice, cover.points[v]));
    cover.point_of.push_back(static_cast<std::uint32_t>(v));
    cover.shift.push_back({});
  }
  add_images(lattice, widened(region), at, cover);
  return cover;
}

// Does the ball of a tet lie in the region? The centre's error is below 2^-38 of the radius, of
// which kSlack is 2^18 times as much.
bool is_proven(const Lattice& lattice, const Region& region, const Cover& cover,
               const TetVertices& tet) {
  const Point3& a = cover.points[tet[0].index()];
  const Point3 offset = voronoi::circumcentre_from(
      a, cover.points[tet[1].index()], cover.points[tet[2].index()], cover.points[tet[3].index()]);
  const double radius = (1 + kSlack) * std::sqrt(dot(offset, offset));
  const std::array<double, 3> centre = coordinates(lattice, a + offset);
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = radius * lattice.slope[i];
    if (!(centre[i] - reach >= region.low[i] && centre[i] + reach <= region.high[i])) return false;
  }
  return true;
}

// Of all tets of points in the cell; their stars are closed, then.
bool all_proven(const Lattice& lattice, const Region& region, const Cover& cover,
                unsigned threads) {
  constexpr std::size_t kStretch = 4096;
  const std::span<const TetVertices> tets = cover.mesh.tets();
  const std::span<const HalfFaceId> opposites = cover.mesh.opposites();
  std::atomic<bool> proven = !tets.empty();
  parallel_for((tets.size() + kStretch - 1) / kStretch, threads, [&](std::size_t stretch) {
    const std::size_t end = std::min(tets.size(), (stretch + 1) * kStretch);
    for (std::size_t t = stretch * kStretch; t < end && proven; ++t) {
      const auto in_cell = [&](VertexId v) { return v.index() < cover.in_cell; };
      if (std::none_of(tets[t].begin(), tets[t].end(), in_cell)) continue;
      bool closed = true;
      for (std::size_t i = 0; i < 4; ++i) closed = closed && opposites[4 * t + i].valid();
      if (!closed || !is_proven(lattice, region, cover, tets[t])) proven = false;
    }
  });
  return proven;
}

Error same_place(const Cover& cover, const Delaunay3& delaunay) {
  Error error{ErrorCode::invalid_input, {}, {}};
  for (const VertexId v : delaunay.representative.ids()) {
    const VertexId w = delaunay.representative[v];
    if (v == w) continue;
    const auto [low, high] = std::minmax(cover.point_of[v.index()], cover.point_of[w.index()]);
    error.message = "points " + std::to_string(low) + " and " + std::to_string(high) +
                    " are at one place of the lattice, or nearer than its grid";
    error.where.vertex = high;
    break;
  }
  return error;
}

}  // namespace

Result<Cover> covered(const Lattice& lattice, const WrappedPoints& wrapped,
                      const Execution& execution) {
  // Some spheres of uniform points are as large.
  const double first_margin =
      3 * std::cbrt(lattice.volume / static_cast<double>(wrapped.points.size()));
  const double last_margin = 2 * (1 + kSlack) * lattice.covering_radius;
  for (double margin = std::min(first_margin, last_margin);;
       margin = std::min(2 * margin, last_margin)) {
    const Region region = region_around(lattice, margin);
    if (expected_images(region, wrapped.points.size()) > most_images(wrapped.points.size())) {
      return Error{ErrorCode::work_limit,
                   "the largest empty spheres are so large for the box that too many images of the "
                   "points are in them",
                   {}};
    }
    Cover cover = images(lattice, wrapped, region);
    Result<Delaunay3> delaunay = delaunay3(
        cover.points, {.engine = DelaunayEngine::incremental, .execution = untold(execution)});
    if (!delaunay) return delaunay.error();
    if (delaunay->duplicates != 0) return same_place(cover, *delaunay);
    cover.mesh = std::move(delaunay->mesh);
    if (margin == last_margin || all_proven(lattice, region, cover, execution.threads)) {
      return cover;
    }
  }
}

}  // namespace tetloft::internal::periodic
