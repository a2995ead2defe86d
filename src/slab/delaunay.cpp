#include "slab/delaunay.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/guard.hpp"
#include "core/watched_work.hpp"
#include "slab/bases.hpp"
#include "slab/work_limit.hpp"

namespace tetloft::internal {

namespace {

// The section that shows best why there are so many tets has the most vertices; its first one
// is the place.
Error too_much_work(SlabId id, const ConformingSection& lower, const ConformingSection& upper,
                    std::size_t most_tets) {
  Place place;
  place.slab = id.index();
  const bool below = lower.vertex_count() >= upper.vertex_count();
  place.point = (below ? lower : upper).point3(PlaneVertexId(0));
  return {ErrorCode::work_limit,
          "the Delaunay triangulation of " +
              std::to_string(lower.vertex_count() + upper.vertex_count()) +
              " vertices takes more than " + std::to_string(most_tets) +
              " tets, the work limit, as it does where round contours of many vertices lie about "
              "different centres: round coordinates to 16 bits, or fewer, which breaks the circles "
              "(--snap 16), take fewer vertices to a contour, or raise the limit",
          place};
}

Result<SlabDelaunay> delaunay_of(const ConformingSection& lower, const ConformingSection& upper,
                                 DelaunayEngine engine, std::size_t most_tets) {
  if (engine != DelaunayEngine::incremental) {
    std::optional<SlabDelaunay> d = delaunay3_detail::slab_overlay_with_bases(
        lower.triangulation, upper.triangulation, WatchedWork({}, 1), most_tets);
    if (!d) return Error{ErrorCode::work_limit, {}, {}};
    return *std::move(d);
  }
  std::vector<Point3> points;
  points.reserve(lower.vertex_count() + upper.vertex_count());
  for (std::size_t i = 0; i < lower.vertex_count(); ++i)
    points.push_back(lower.point3(PlaneVertexId(i)));
  for (std::size_t i = 0; i < upper.vertex_count(); ++i)
    points.push_back(upper.point3(PlaneVertexId(i)));
  Result<Delaunay3> d = delaunay3(points, {.engine = engine, .most_tets = most_tets});
  if (!d) return d.error();
  TETLOFT_CHECK(d->dimension == 3 && d->duplicates == 0);
  return with_bases(lower, upper, std::move(d->mesh));
}

}  // namespace

Result<SlabDelaunay> slab_delaunay(SlabId id, const ConformingSection& lower,
                                   const ConformingSection& upper, DelaunayEngine engine,
                                   double work_limit) {
  const std::size_t most_tets =
      std::min(delaunay3_detail::kMostTetSlots,
               most_work(work_limit, lower.vertex_count() + upper.vertex_count()));
  Result<SlabDelaunay> d = delaunay_of(lower, upper, engine, most_tets);
  if (d || d.error().code != ErrorCode::work_limit) return d;
  return too_much_work(id, lower, upper, most_tets);
}

}  // namespace tetloft::internal
