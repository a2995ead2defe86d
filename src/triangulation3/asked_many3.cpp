// Many points asked about at once: answers in the order of the points, found in one that is fast,
// by several threads.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/asked_together.hpp"
#include "core/parallel.hpp"
#include "delaunay3/batch.hpp"
#include "delaunay3/canonical_order.hpp"
#include "delaunay3/spatial_order.hpp"
#include "triangulation3/handles3.hpp"
#include "triangulation3/nearest.hpp"

namespace tetloft {

using namespace internal;

namespace {

// The points along a curve: near ones follow each other, and what one search reads the next one
// finds in the cache.
std::vector<std::uint32_t> order_of_asking(std::span<const Point3> points, unsigned threads) {
  const std::vector<std::uint32_t> canonical = delaunay3_detail::canonical_order(points, threads);
  const std::vector<Point3> ranked = delaunay3_detail::picked<Point3>(points, canonical, threads);
  return delaunay3_detail::picked<std::uint32_t>(
      canonical, delaunay3_detail::insertion_order(ranked, threads), threads);
}

// result[i] is ask(points[i], the answer before or null), without vertices `Answer()`.
template <class Answer, class Ask>
Result<std::vector<Answer>> asked_of_all(std::span<const Point3> points, std::size_t vertices,
                                         const Execution& execution, const Ask& ask) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<Answer>> {
    if (Result<void> fine = triangulation3::check_points(points); !fine) return fine.error();
    if (vertices == 0) return std::vector<Answer>(points.size());
    if (points.empty()) return std::vector<Answer>();
    const std::vector<std::uint32_t> order = order_of_asking(points, own.threads);
    return asked_together<Answer>(
        order, own, [&](std::uint32_t i, const Answer* before) { return ask(points[i], before); });
  });
}

}  // namespace

Result<std::vector<Location3>> DelaunayTriangulation3::locate(std::span<const Point3> points,
                                                              const Execution& execution) const {
  const Impl& impl = get();
  return asked_of_all<Location3>(
      points, vertex_count(), execution, [&](const Point3& p, const Location3* before) {
        return impl.location(p, before == nullptr ? VertexId() : impl.hint(before->vertices[0]));
      });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation3::nearest_vertex(
    std::span<const Point3> points, const Execution& execution) const {
  const Impl& impl = get();
  return asked_of_all<DelaunayVertex>(
      points, vertex_count(), execution, [&](const Point3& p, const DelaunayVertex* before) {
        const VertexId near = before == nullptr ? VertexId() : impl.hint(*before);
        return impl.handle(triangulation3::Nearest(impl.tets, p, near).first());
      });
}

}  // namespace tetloft
