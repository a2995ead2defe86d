// Voronoi cells of a DelaunayTriangulation2, whole or clipped to a rectangle; natural neighbours.
//
// As in voronoi.hpp the neighbours of a cell are the triangulation's, exact, and measures are
// doubles, computed relative to the site.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/delaunay_triangulation2.hpp>
#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/voronoi.hpp>

namespace tetloft {

/// What cells are clipped to: low <= high in both coordinates.
struct ClippingRectangle {
  Point2 low;
  Point2 high;
};

struct VoronoiEdge2 {
  /// Whose cell is across; none where the edge lies on the rectangle.
  DelaunayVertex neighbour{};
  BoxSide side = BoxSide::none;
  /// Is anything of it in the rectangle? Always of cells that are not clipped.
  bool inside = false;
  /// An end that is none: the edge goes on without end there. Only of cells that are not clipped.
  static constexpr std::uint32_t kEndless = 0xFFFFFFFFU;
  /// Where it is, places in the cell's `corners`, counter-clockwise around the cell.
  std::array<std::uint32_t, 2> ends{};
  double length = 0;  ///< infinite where it has no end
};

struct VoronoiCell2 {
  DelaunayVertex site{};
  /// Of the whole cell: false where it goes on without end, if only beyond the rectangle, as those
  /// of vertices on the hull do, and all of points in a row.
  bool bounded = true;
  /// Counter-clockwise; they may coincide. Of triangles on the hull that are flat enough a centre
  /// may be beyond the range of doubles, infinite.
  std::vector<Point2> corners;
  /// One for each neighbour of the triangulation, by index; then the sides of the rectangle, in
  /// order, that the cell has an edge on.
  std::vector<VoronoiEdge2> edges;
  double area = 0;  ///< infinite of a whole cell without end
};

/// The cell of a vertex. Refused (invalid_input) where there are constraints, whose triangulation
/// is another one than that of the cells, where the vertex is none, and where coordinates of it or
/// its neighbours are beyond 2^300.
[[nodiscard]] TETLOFT_API Result<VoronoiCell2> voronoi_cell(
    const DelaunayTriangulation2& triangulation, DelaunayVertex site);

/// The areas of all whole cells, by index of vertex: infinite where unbounded, 0 in places without
/// a vertex. Refused as above.
[[nodiscard]] TETLOFT_API Result<std::vector<double>> voronoi_areas(
    const DelaunayTriangulation2& triangulation, const Execution& execution = {});

/// What of a vertex's cell is in a rectangle, which the site need not be in; perhaps nothing. The
/// areas of all sum to the rectangle's. Refused also where a corner of the rectangle is not finite
/// or beyond 2^300, and where its low corner is not low.
[[nodiscard]] TETLOFT_API Result<VoronoiCell2> voronoi_cell(
    const DelaunayTriangulation2& triangulation, DelaunayVertex site,
    const ClippingRectangle& rectangle);
/// The cells of all vertices, by increasing index.
[[nodiscard]] TETLOFT_API Result<std::vector<VoronoiCell2>> voronoi_cells(
    const DelaunayTriangulation2& triangulation, const Execution& execution = {});
[[nodiscard]] TETLOFT_API Result<std::vector<VoronoiCell2>> voronoi_cells(
    const DelaunayTriangulation2& triangulation, const ClippingRectangle& rectangle,
    const Execution& execution = {});

/// The vertices that would be neighbours of a new one at the point, weighted as in space, with
/// areas for volumes and lengths for areas; at a vertex it alone, on an edge of the hull its ends.
/// `near` is a vertex to start the search at. Refused (invalid_input) where there are constraints,
/// where the point is outside of the hull, not finite or, as its neighbours, beyond 2^300, and
/// where the vertices span no plane; (usage) for weights that there are none of.
[[nodiscard]] TETLOFT_API Result<NaturalNeighbours> natural_neighbours(
    const DelaunayTriangulation2& triangulation, const Point2& point,
    NaturalWeights weights = NaturalWeights::sibson, DelaunayVertex near = {});

/// Of each point what natural_neighbours() of it gives, to the bit; nothing where that refuses it
/// as outside of the hull, or as the vertices span no plane. Refused are all where one is not
/// finite or, as its neighbours, beyond 2^300, and where there are constraints.
[[nodiscard]] TETLOFT_API Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation2& triangulation, std::span<const Point2> points,
    NaturalWeights weights = NaturalWeights::sibson, const Execution& execution = {});

}  // namespace tetloft
