// The Voronoi diagram of a DelaunayTriangulation3: cells with volumes, faces and neighbours, whole
// or clipped to a box; circumspheres.
//
// Which neighbours a cell has is the triangulation's, exact: one face for each of its edges. Of
// points on a common sphere, as on lattices, some of these faces are a point or a line: their area
// is 0, or what rounding left of it, and no true neighbour is missing. Corners, areas and volumes
// are doubles, computed relative to the site, so that sets far from the origin lose nothing;
// nothing is decided by them.
//
// Coordinates of sites and boxes must be at most 2^300 in magnitude; volumes below 2^-1022 vanish.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/delaunay_triangulation3.hpp>
#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

struct Sphere3 {
  Point3 centre;
  double radius = 0;
};
/// The sphere through four points, rounded: from exact determinants where the tet is nearly flat.
/// Of coplanar points, and of such that are not finite, the radius is infinite, and the centre not
/// a number. Does not depend on the orientation.
[[nodiscard]] TETLOFT_API Sphere3 circumsphere(const Point3& a, const Point3& b, const Point3& c,
                                               const Point3& d);

/// What cells are clipped to: low <= high in every coordinate.
struct ClippingBox {
  Point3 low;
  Point3 high;
};

/// The sides of a ClippingBox.
enum class BoxSide : std::uint8_t { none, low_x, high_x, low_y, high_y, low_z, high_z };
/// "none", "low x", "high x" …
[[nodiscard]] TETLOFT_API const char* name_of(BoxSide side);

struct VoronoiFace3 {
  /// Whose cell is across; none where the face lies on the box.
  DelaunayVertex neighbour{};
  BoxSide side = BoxSide::none;
  /// False: it goes on without end. Only of cells that are not clipped.
  bool bounded = true;
  /// Places in the cell's `corners`, counter-clockwise as seen from outside; of an unbounded face
  /// those that there are. Corners may coincide. Empty where nothing of the face is in the box.
  std::vector<std::uint32_t> corners;
  double area = 0;  ///< infinite where unbounded
};

struct VoronoiCell3 {
  DelaunayVertex site{};
  /// False: it goes on without end, as cells of vertices on the hull do, and all cells of points
  /// that span no space.
  bool bounded = true;
  /// Of tets on the hull that are flat enough a centre may be beyond the range of doubles,
  /// infinite.
  std::vector<Point3> corners;
  /// One for each neighbour of the triangulation, by index; then the sides of the box, in order,
  /// that the cell has a face on.
  std::vector<VoronoiFace3> faces;
  double volume = 0;  ///< infinite where unbounded
};

/// The cell of a vertex. Refused (invalid_input) where the vertex is none, or coordinates of it or
/// its neighbours are too large.
[[nodiscard]] TETLOFT_API Result<VoronoiCell3> voronoi_cell(
    const DelaunayTriangulation3& triangulation, DelaunayVertex site);
/// What of it is in a box, which the site need not be in: always bounded, perhaps empty. The
/// volumes of all sum to the box's. Refused also where the box's low corner is not low, or not
/// finite.
[[nodiscard]] TETLOFT_API Result<VoronoiCell3> voronoi_cell(
    const DelaunayTriangulation3& triangulation, DelaunayVertex site, const ClippingBox& box);

/// The volumes of all whole cells, by index of vertex: infinite where unbounded, 0 in places
/// without a vertex. Several times as fast as making the cells. Refused as above.
[[nodiscard]] TETLOFT_API Result<std::vector<double>> voronoi_volumes(
    const DelaunayTriangulation3& triangulation, const Execution& execution = {});

/// The cells of all vertices, by increasing index.
[[nodiscard]] TETLOFT_API Result<std::vector<VoronoiCell3>> voronoi_cells(
    const DelaunayTriangulation3& triangulation, const Execution& execution = {});
[[nodiscard]] TETLOFT_API Result<std::vector<VoronoiCell3>> voronoi_cells(
    const DelaunayTriangulation3& triangulation, const ClippingBox& box,
    const Execution& execution = {});

/// How natural neighbours are weighted: by what a new vertex's cell would take of theirs (Sibson,
/// "A brief description of natural neighbour interpolation", 1981), or by area over distance of its
/// faces (Belikov et al., "The non-Sibsonian interpolation", 1997), which takes less time.
enum class NaturalWeights : std::uint8_t { sibson, laplace };
/// "sibson", "laplace".
[[nodiscard]] TETLOFT_API const char* name_of(NaturalWeights weights);

struct NaturalNeighbours {
  std::vector<DelaunayVertex> vertices;  ///< by index
  /// Theirs: not negative, of sum 1, and to rounding the point is the weighted mean of the
  /// vertices; nearer to the hull than some 10^-5 of their distance, to as much of that.
  std::vector<double> weights;
};
/// The vertices that would be neighbours of a new one at the point, weighted; at a vertex it alone.
/// On the hull those of its plane or edge, as the weights tend to. `near` is a vertex to start the
/// search at. Refused (invalid_input) where the point is outside of the hull, not finite or, as
/// its neighbours, beyond 2^300, and where the vertices span no space; (usage) for weights that
/// there are none of.
[[nodiscard]] TETLOFT_API Result<NaturalNeighbours> natural_neighbours(
    const DelaunayTriangulation3& triangulation, const Point3& point,
    NaturalWeights weights = NaturalWeights::sibson, DelaunayVertex near = {});

/// Of points in their order, one after the other: those of point i are vertices[begin[i]] to
/// before vertices[begin[i + 1]], and their weights.
struct NaturalNeighboursOfMany {
  std::vector<std::size_t> begin;  ///< one more than points
  std::vector<DelaunayVertex> vertices;
  std::vector<double> weights;
};
/// Of each point what natural_neighbours() of it gives, to the bit; nothing where that refuses it
/// as outside of the hull, or as the vertices span no space. Refused are all where one is not
/// finite or, as its neighbours, beyond 2^300.
[[nodiscard]] TETLOFT_API Result<NaturalNeighboursOfMany> natural_neighbours_of_many(
    const DelaunayTriangulation3& triangulation, std::span<const Point3> points,
    NaturalWeights weights = NaturalWeights::sibson, const Execution& execution = {});

}  // namespace tetloft
