// From a point set to its incremental triangulation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "core/watched_work.hpp"
#include "delaunay2/incremental.hpp"

namespace tetloft::internal::delaunay2_detail {

/// An incremental triangulation, which numbers vertices in order of insertion, and how that becomes
/// the numbering of its owner: indices of input points.
struct Start {
  /// Nothing if all points are collinear.
  std::optional<Incremental2> plane;
  /// The lowest index of an input point with its coordinates; invalid
  /// for the ghost.
  IdVector<SiteId, PlaneVertexId> input_of;
  /// Duplicates have the same.
  IdVector<PlaneVertexId, SiteId> site_of;
};

/// A step of the work: so many points.
inline constexpr std::size_t kPointsOfStep = 4096;
[[nodiscard]] constexpr std::size_t steps_of(std::span<const Point2> points) {
  return points.size() / kPointsOfStep;
}

/// Requires finite points, fewer than Incremental2::kMostVertices. Tells steps_of(points), unless
/// there is no plane.
[[nodiscard]] Start triangulate(std::span<const Point2> points, WatchedWork& work);

}  // namespace tetloft::internal::delaunay2_detail
