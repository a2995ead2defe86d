// The Voronoi cells of the points of `delaunay`, as polyhedra in a file.
#pragma once

#include <tetloft/io.hpp>
#include <tetloft/result.hpp>

#include "cli/arguments.hpp"
#include "cli/triangulated_once.hpp"

namespace tetloft::cli {

/// --voronoi.
[[nodiscard]] Option voronoi_option();
/// How its file may end.
inline constexpr const char* kVoronoiExtension = ".vtu";

/// The cells, clipped to a box about the points; data "point" (input index), "volume" and
/// "neighbours" (cells across faces that have corners), "clipped" (1 where it has a face on the
/// box). Refused (invalid_input) where coordinates are too large for cells.
[[nodiscard]] Result<PolyhedronSet> voronoi_polyhedra(TriangulatedOnce& points);

}  // namespace tetloft::cli
