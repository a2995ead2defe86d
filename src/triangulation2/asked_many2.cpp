// Many points asked about at once: answers in the order of the points, found in one that is fast,
// by several threads.
#include <cstdint>
#include <span>
#include <vector>

#include "core/asked_together.hpp"
#include "core/parallel.hpp"
#include "delaunay2/spatial_order.hpp"
#include "triangulation2/handles2.hpp"

namespace tetloft {

using namespace internal;

namespace {

// result[i] is ask(points[i], the answer before or null), which is a Result.
template <class Answer, class Ask>
Result<std::vector<Answer>> asked_of_plane_points(std::span<const Point2> points,
                                                  const Execution& execution, const Ask& ask) {
  return guard_threads(execution, [&](const Execution& own) -> Result<std::vector<Answer>> {
    if (Result<void> fine = triangulation2::check_points(points); !fine) return fine.error();
    if (points.empty()) return std::vector<Answer>();
    return asked_together<Answer>(delaunay2_detail::insertion_order(points), own,
                                  [&](std::uint32_t i, const Answer* before) {
                                    Result<Answer> answer = ask(points[i], before);
                                    if (!answer) throw Failed(answer.error());
                                    return *answer;
                                  });
  });
}

}  // namespace

Result<std::vector<Location2>> DelaunayTriangulation2::locate(std::span<const Point2> points,
                                                              const Execution& execution) const {
  return asked_of_plane_points<Location2>(
      points, execution, [&](const Point2& p, const Location2* before) {
        return locate(p, before == nullptr ? DelaunayVertex() : before->vertices[0]);
      });
}

Result<std::vector<DelaunayVertex>> DelaunayTriangulation2::nearest_vertex(
    std::span<const Point2> points, const Execution& execution) const {
  return asked_of_plane_points<DelaunayVertex>(
      points, execution, [&](const Point2& p, const DelaunayVertex* before) {
        return nearest_vertex(p, before == nullptr ? DelaunayVertex() : *before);
      });
}

}  // namespace tetloft
