// A Voronoi cell as the dual of a star: corners are centres of tets, faces rings of edges.
#pragma once

#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/voronoi.hpp>

namespace tetloft::internal::voronoi {

/// The whole cell, perhaps unbounded. Requires a live vertex and its neighbours by index.
[[nodiscard]] VoronoiCell3 dual_cell(const DelaunayTriangulation3& triangulation,
                                     DelaunayVertex site,
                                     const std::vector<DelaunayVertex>& neighbours);

}  // namespace tetloft::internal::voronoi
