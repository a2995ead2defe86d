// The API boundary: what is refused, and the trivial cases without triangles.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/predicates.hpp>

#include "core/guard.hpp"
#include "delaunay2/canonical.hpp"
#include "delaunay2/conforming.hpp"
#include "delaunay2/incremental.hpp"
#include "delaunay2/start.hpp"

namespace tetloft {

using namespace internal;

namespace {

using delaunay2_detail::ConformedPlane;
using delaunay2_detail::Incremental2;

Error refuse(std::string message, std::span<const Point2> points, std::size_t vertex) {
  Error error{ErrorCode::invalid_input, std::move(message), {}};
  error.where.vertex = vertex;
  if (vertex < points.size()) error.where.point = Point3{points[vertex].x, points[vertex].y, 0};
  return error;
}

Result<void> verify_points(std::span<const Point2> points) {
  if (Result<void> fp = fp_self_check(); !fp) return fp;
  if (points.size() >= Incremental2::kMostVertices) {
    return Error{ErrorCode::invalid_input, "2^29 points or more in one plane", {}};
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) {
      return refuse("coordinate is not finite", points, i);
    }
  }
  return {};
}

Result<void> verify_distinct(std::span<const Point2> points,
                             const std::vector<PlaneVertexId>& representative) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (representative[i].index() == i) continue;
    return refuse("same point as vertex " + std::to_string(representative[i].value()), points, i);
  }
  return {};
}

Result<void> verify_segments(std::span<const Point2> points, std::span<const Segment> segments) {
  const auto name = [](std::size_t s) { return "segment " + std::to_string(s); };
  for (std::size_t s = 0; s < segments.size(); ++s) {
    for (const PlaneVertexId v : segments[s]) {
      if (v.index() >= points.size()) {
        return Error{ErrorCode::invalid_input, name(s) + " has an end that is no vertex", {}};
      }
    }
    if (segments[s][0] == segments[s][1]) {
      return refuse(name(s) + " has the same vertex at both ends", points, segments[s][0].index());
    }
  }
  std::vector<std::pair<Segment, std::size_t>> sorted;
  sorted.reserve(segments.size());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [low, high] = std::minmax({segments[s][0], segments[s][1]});
    sorted.push_back({Segment{low, high}, s});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i - 1].first != sorted[i].first) continue;
    return refuse(name(sorted[i].second) + " repeats " + name(sorted[i - 1].second), points,
                  sorted[i].first[0].index());
  }
  return {};
}

/// Splits only ever happen among points that make triangles; this is the range of Ray.
Result<void> verify_range(std::span<const Point2> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::max(std::abs(points[i].x), std::abs(points[i].y)) > kLargestSplitCoordinate) {
      return refuse("coordinate beyond 2^1000", points, i);
    }
  }
  return {};
}

/// Points on a line have no triangles; segments that do not overlap join neighbours.
Result<ConformedPlane> conform_collinear(std::span<const Point2> points,
                                         std::span<const Segment> segments) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a] == points[b] ? a < b : canonical_less(points[a], points[b]);
  });
  std::vector<std::size_t> rank(points.size());
  std::vector<PlaneVertexId> representative(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_duplicate = i > 0 && points[order[i - 1]] == points[order[i]];
    representative[order[i]] =
        is_duplicate ? representative[order[i - 1]] : PlaneVertexId(order[i]);
    rank[order[i]] = i;
  }
  if (Result<void> valid = verify_distinct(points, representative); !valid) return valid.error();
  ConformedPlane result;
  result.points.assign(points.begin(), points.end());
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [low, high] =
        std::minmax({rank[segments[s][0].index()], rank[segments[s][1].index()]});
    if (high - low > 1) {
      return refuse("segment " + std::to_string(s) + " passes through a vertex", points,
                    order[low + 1]);
    }
    result.chains.add(segments[s][0]);
    result.chains.add(segments[s][1]);
    result.chains.end_chain();
  }
  return result;
}

/// What the arguments are asked before anything is made of them.
Result<void> verify_arguments(std::span<const Point2> points, std::span<const Segment> segments,
                              const ConformingOptions& options) {
  if (Result<void> valid = verify_points(points); !valid) return valid;
  if (!options.gabriel.empty() && options.gabriel.size() != segments.size()) {
    return Error{ErrorCode::usage, "as many gabriel flags as segments, or none", {}};
  }
  return {};
}

Result<ConformedPlane> conform_verified(std::span<const Point2> points,
                                        std::span<const Segment> segments,
                                        const ConformingOptions& options) {
  WatchedWork work(options.execution, delaunay2_detail::steps_of(points) + 1);
  work.go_on();
  delaunay2_detail::Start start = delaunay2_detail::triangulate(points, work);
  if (!start.plane) return conform_collinear(points, segments);
  std::vector<PlaneVertexId> representative(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    representative[i] = start.input_of[start.site_of[PlaneVertexId(i)]];
  }
  if (Result<void> valid = verify_distinct(points, representative); !valid) return valid.error();
  if (Result<void> valid = verify_range(points); !valid) return valid.error();
  const std::size_t bound = options.most_inserted != 0
                                ? options.most_inserted
                                : (std::size_t{1} << 16) + 64 * (points.size() + segments.size());
  Result<ConformedPlane> result = delaunay2_detail::conform(
      std::move(start), points, segments, options.gabriel,
      std::min(bound, Incremental2::kMostVertices - 1 - points.size()), work);
  if (result) work.step_done();
  return result;
}

Conforming2 canonical_form(ConformedPlane conformed, std::size_t input_count) {
  Conforming2 result;
  result.split.resize(conformed.points.size() - input_count);
  result.chains.resize(conformed.chains.size());
  for (std::size_t s = 0; s < result.chains.size(); ++s) {
    const std::span<const PlaneVertexId> chain = conformed.chains[s];
    result.chains[s].assign(chain.begin(), chain.end());
    for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
      result.split[chain[i].index() - input_count] = {s, i - 1};
    }
  }
  if (conformed.start.plane) {
    result.triangulation = delaunay2_detail::canonical_triangulation(
        *conformed.start.plane, conformed.start.input_of, std::move(conformed.points));
  } else {
    result.triangulation.points = IdVector<PlaneVertexId, Point2>(std::move(conformed.points));
  }
  return result;
}

}  // namespace

Result<Triangulation2> delaunay2(std::span<const Point2> points, const Execution& execution) {
  return guard_internal([&]() -> Result<Triangulation2> {
    if (Result<void> valid = verify_points(points); !valid) return valid.error();
    WatchedWork work(execution, delaunay2_detail::steps_of(points) + 1);
    work.go_on();
    const delaunay2_detail::Start start = delaunay2_detail::triangulate(points, work);
    std::vector<Point2> copy(points.begin(), points.end());
    if (!start.plane) {
      return Triangulation2{IdVector<PlaneVertexId, Point2>(std::move(copy)), {}, {}};
    }
    Triangulation2 result =
        delaunay2_detail::canonical_triangulation(*start.plane, start.input_of, std::move(copy));
    work.step_done();
    return result;
  });
}

Result<ConformedPlane> delaunay2_detail::conformed_plane(std::span<const Point2> points,
                                                         std::span<const Segment> segments,
                                                         const ConformingOptions& options) {
  if (Result<void> valid = verify_arguments(points, segments, options); !valid) {
    return valid.error();
  }
  return conform_verified(points, segments, options);
}

Result<Conforming2> conforming_delaunay2(std::span<const Point2> points,
                                         std::span<const Segment> segments,
                                         const ConformingOptions& options) {
  return guard_internal([&]() -> Result<Conforming2> {
    Result<void> valid = verify_arguments(points, segments, options);
    if (valid) valid = verify_segments(points, segments);
    if (!valid) return valid.error();
    Result<ConformedPlane> conformed = conform_verified(points, segments, options);
    if (!conformed) return conformed.error();
    return canonical_form(*std::move(conformed), points.size());
  });
}

}  // namespace tetloft
