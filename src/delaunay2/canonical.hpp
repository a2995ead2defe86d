// The canonical form of a finished triangulation: a function of the point set alone, up to
// the numbering of the points.
#pragma once

#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>

#include "delaunay2/incremental.hpp"

namespace tetloft::internal::delaunay2_detail {

/// The real triangles of `plane` with vertices renamed by `name_of` (by vertex of `plane`),
/// each rotated to start at its lowest vertex, sorted, with their neighbours. `points` are
/// by new name. Linear but for sorting the triangles that share their lowest vertex.
[[nodiscard]] Triangulation2 canonical_triangulation(const Incremental2& plane,
                                                     const IdVector<SiteId, PlaneVertexId>& name_of,
                                                     std::vector<Point2> points);

}  // namespace tetloft::internal::delaunay2_detail
