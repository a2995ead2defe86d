// Many points into a triangulation that has some: handles in the order of the points, insertion in
// one that is fast.
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/watched_work.hpp"
#include "delaunay3/batch.hpp"
#include "delaunay3/canonical_order.hpp"
#include "delaunay3/spatial_order.hpp"
#include "triangulation3/handles3.hpp"

namespace tetloft {

using namespace internal;

namespace {

// So many points between two looks at the stop token.
constexpr std::size_t kPointsOfLook3 = 1024;

// first[i]: the lowest index with the point of i.
std::vector<std::uint32_t> first_of_equal(std::span<const Point3> points,
                                          std::span<const std::uint32_t> canonical) {
  std::vector<std::uint32_t> first(points.size());
  std::uint32_t last = 0;
  for (std::size_t k = 0; k < canonical.size(); ++k) {
    if (k == 0 || points[canonical[k]] != points[last]) last = canonical[k];
    first[canonical[k]] = last;
  }
  return first;
}

// The distinct points, by index, in the order in which they are inserted.
std::vector<std::uint32_t> spatially(std::span<const Point3> points,
                                     std::span<const std::uint32_t> canonical,
                                     std::span<const std::uint32_t> first) {
  std::vector<std::uint32_t> distinct;
  for (const std::uint32_t i : canonical) {
    if (first[i] == i) distinct.push_back(i);
  }
  const std::vector<Point3> ranked = delaunay3_detail::picked<Point3>(points, distinct, 1);
  return delaunay3_detail::picked<std::uint32_t>(distinct,
                                                 delaunay3_detail::insertion_order(ranked), 1);
}

}  // namespace

std::vector<DelaunayVertex> DelaunayTriangulation3::Impl::insert_all(std::span<const Point3> points,
                                                                     const Execution& execution) {
  WatchedWork work(execution, points.size() / kPointsOfLook3 + 1);
  work.go_on();
  const std::vector<std::uint32_t> canonical = delaunay3_detail::canonical_order(points);
  const std::vector<std::uint32_t> first = first_of_equal(points, canonical);
  const std::vector<std::uint32_t> order = spatially(points, canonical, first);
  std::vector<VertexId> vertex(points.size());
  std::vector<DelaunayVertex> handles(points.size());
  std::vector<VertexId> inserted;  // places taken, in order of points
  inserted.reserve(order.size());
  provide_room(places.free, order.size());
  const auto give_back_unused = [&] {
    std::erase_if(inserted, [&](VertexId v) { return tets.is_live(v); });
    give_back(inserted);
  };
  try {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (first[i] != i) continue;
      vertex[i] = provide(points[i]);
      inserted.push_back(vertex[i]);
      places.take();
    }
    VertexId last;
    for (std::size_t k = 0; k < order.size(); ++k) {
      VertexId& v = vertex[order[k]];
      v = tets.insert(v, last);
      last = v;
      if ((k + 1) % kPointsOfLook3 == 0) work.step_done_go_on();
    }
  } catch (...) {
    try {
      for (const VertexId v : inserted) {
        if (tets.is_live(v)) tets.remove(v);
      }
    } catch (...) {
      // Without memory even for that, the others stay.
    }
    give_back_unused();
    throw;
  }
  give_back_unused();
  for (std::size_t i = 0; i < points.size(); ++i) handles[i] = handle(vertex[first[i]]);
  work.step_done();
  return handles;
}

}  // namespace tetloft
