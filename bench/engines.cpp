// The library's engines without their last step. The only file that knows their internals.
#include "engines.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include <tetloft/delaunay.hpp>

#include "delaunay2/start.hpp"
#include "delaunay3/affine_basis.hpp"
#include "delaunay3/canonical_order.hpp"
#include "delaunay3/incremental.hpp"
#include "delaunay3/slab_overlay.hpp"
#include "delaunay3/spatial_order.hpp"
#include "measure.hpp"

namespace tetloft::bench {

using namespace internal;

namespace {

const Execution kUnwatched{.threads = 1};

std::vector<Point3> sorted(std::span<const Point3> points) {
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const std::uint32_t place : delaunay3_detail::canonical_order(points)) {
    if (result.empty() || result.back() != points[place]) result.push_back(points[place]);
  }
  return result;
}

}  // namespace

Run incremental3(std::span<const Point3> points) {
  const Clock clock;
  const std::vector<Point3> ranked = sorted(points);
  std::vector<std::uint32_t> order = delaunay3_detail::insertion_order(ranked);
  std::vector<Point3> inserted;
  inserted.reserve(order.size());
  for (const std::uint32_t place : order) inserted.push_back(ranked[place]);
  const auto basis = delaunay3_detail::affine_basis(inserted);
  for (std::size_t k = 0; k < basis.place.size(); ++k) {
    const auto begin = order.begin();
    const auto at = begin + static_cast<std::ptrdiff_t>(basis.place[k]);
    std::rotate(begin + static_cast<std::ptrdiff_t>(k), at, at + 1);
  }
  inserted = {};
  delaunay3_detail::Delaunay3Builder builder(ranked, order);
  WatchedWork work(kUnwatched, 0);
  if (!builder.insert_all(work)) throw std::runtime_error("too many tets");
  Run run{clock.seconds(), 0};
  for (const delaunay3_detail::TetSlot& slot : builder.slots()) {
    const VertexId first = slot.vertices[0];
    run.simplices += first.valid() && first != delaunay3_detail::kGhost ? 1U : 0U;
  }
  return run;
}

Run slab3(std::span<const Point3> points) {
  const Clock clock;
  const std::vector<Point3> ranked = sorted(points);
  std::vector<Point2> plane[2];
  for (const Point3& p : ranked) plane[p.z == ranked.front().z ? 0 : 1].push_back({p.x, p.y});
  const auto lower = delaunay2(plane[0]);
  const auto upper = delaunay2(plane[1]);
  WatchedWork work(kUnwatched, 0);
  const auto slab = delaunay3_detail::slab_overlay(
      *lower, *upper, {.input_of = {}, .input_count = ranked.size()}, work);
  return {clock.seconds(), slab->tet_count()};
}

Run whole_call3(std::span<const Point3> points, unsigned threads) {
  const Clock clock;
  const auto d = delaunay3(points, {.execution = {.threads = threads}});
  const double seconds = clock.seconds();
  return {seconds, d->mesh.tet_count()};
}

Run incremental2(std::span<const Point2> points) {
  const Clock clock;
  WatchedWork work(kUnwatched, 0);
  const auto start = delaunay2_detail::triangulate(points, work);
  const double seconds = clock.seconds();
  Run run{seconds, 0};
  if (!start.plane) return run;
  for (std::size_t t = 0; t < start.plane->triangle_count(); ++t) {
    run.simplices += start.plane->is_ghost(TriangleId(t)) ? 0U : 1U;
  }
  return run;
}

Run whole_call2(std::span<const Point2> points) {
  const Clock clock;
  const auto d = delaunay2(points);
  const double seconds = clock.seconds();
  return {seconds, d->triangles.size()};
}

}  // namespace tetloft::bench
