// Distances of points from edges in integers, for what bounds in doubles cannot decide.
#pragma once

#include <span>

#include <tetloft/point.hpp>

#include "sections/contour_edges.hpp"

namespace tetloft::internal::sections {

struct PointAndEdge {
  Point2 p;
  ContourEdges::Edge edge;
};

/// The smallest distance of a point from its edge, rounded once to `bits` significant bits (at most
/// 50), halves up; once more where that is no double. Requires a pair, and positive distances.
[[nodiscard]] double smallest_distance(std::span<const PointAndEdge> pairs, int bits);

}  // namespace tetloft::internal::sections
