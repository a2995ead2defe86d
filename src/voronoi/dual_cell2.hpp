// A whole cell of the plane: centres of the triangles around its site.
#pragma once

#include <vector>

#include <tetloft/voronoi2.hpp>

namespace tetloft::internal::voronoi {

/// The centre of the circle through three points minus a, with an error of some units in the last
/// place of its length, of flat triangles at most 2^-39 of it; but where the differences of points
/// span more than 2^300. Not a number where the points are in a row, exactly.
[[nodiscard]] Point2 circle_centre_from(const Point2& a, const Point2& b, const Point2& c);

/// `neighbours` are the site's, by index.
[[nodiscard]] VoronoiCell2 dual_cell(const DelaunayTriangulation2& triangulation,
                                     DelaunayVertex site,
                                     const std::vector<DelaunayVertex>& neighbours);

}  // namespace tetloft::internal::voronoi
