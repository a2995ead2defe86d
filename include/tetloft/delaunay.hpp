// Delaunay triangulations: of points in space, and of points and segments in the plane.
//
// Both are the unique triangulation of the symbolically perturbed predicates
// (predicates.hpp): they depend on the set of points only, never on input order.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft {

/// The 3D Delaunay triangulation of a point set.
struct Delaunay3 {
  /// Vertices are the input points by index. Tets are positive, numbered canonically: each
  /// tet's vertices are an even permutation of increasing canonical rank (the last two
  /// swapped where the orientation asks for it), tets sorted by their ranks. Without tets
  /// if dimension < 3. Its boundary is the convex hull.
  TetMesh mesh;
  /// Dimension of the affine hull: −1 without points, 0 one point, 1 collinear, 2
  /// coplanar, 3 otherwise.
  int dimension = -1;
  /// representative[v] is v, or for a duplicate the lowest index with the same point; a
  /// duplicate is in no tet.
  IdVector<VertexId, VertexId> representative;
  std::size_t duplicates = 0;
};

/// Incremental insertion (Bowyer 1981; Watson 1981) in spatially sorted order with a
/// ghost vertex. Refused (invalid_input) where a coordinate is not finite, naming the
/// vertex.
[[nodiscard]] Result<Delaunay3> delaunay3(std::span<const Point3> points);

/// A triangulation of points in the plane with its Voronoi dual.
struct Triangulation2 {
  IdVector<VertexId, Point2> points;
  /// Counter-clockwise, each starting at its lowest vertex, sorted. Empty if all points
  /// are collinear.
  IdVector<TriangleId, TriangleVertices> triangles;
  /// neighbours[t][i] is the triangle across the edge opposite vertex i, or invalid on the
  /// convex hull.
  IdVector<TriangleId, std::array<TriangleId, 3>> neighbours;
};

/// The 2D Delaunay triangulation. Vertices are the input points by index; of duplicates
/// only the lowest index is used. Refused where a coordinate is not finite.
[[nodiscard]] Result<Triangulation2> delaunay2(std::span<const Point2> points);

/// A segment to be respected, by the indices of its ends.
using Segment = std::array<VertexId, 2>;

/// What conforming_delaunay2 inserted.
struct SplitVertex {
  std::size_t segment = 0;  ///< index of the input segment it lies on
  std::size_t position = 0;  ///< its place along the segment, from the first end, from 0
};

struct ConformingOptions {
  /// segments whose subsegments must be Gabriel: no vertex in or on their diametral
  /// circle but their ends. Empty: none. Otherwise one flag per segment.
  std::vector<bool> gabriel;
};

/// A Delaunay triangulation in which every segment is a union of edges.
struct Conforming2 {
  /// Points: first the input, then the inserted ones.
  Triangulation2 triangulation;
  /// split[i] describes point n + i, n the number of input points.
  std::vector<SplitVertex> split;
  /// chains[s]: the vertices of segment s from its first to its second end, both included.
  std::vector<std::vector<VertexId>> chains;
};

/// Splits every segment that is not an edge of the Delaunay triangulation, all of one
/// round together, until none is missing: at the midpoint, near acute corners on
/// concentric shells of power-of-two radius (Ruppert 1995; Shewchuk 2002). Every inserted
/// point is rounded once and is input from then on.
/// Requires distinct points and segments that do not cross or touch but at shared ends.
/// Fails (unrepresentable, naming the point) when rounding leaves no room to split.
[[nodiscard]] Result<Conforming2> conforming_delaunay2(std::span<const Point2> points,
                                                       std::span<const Segment> segments,
                                                       const ConformingOptions& options = {});

/// The Voronoi vertex dual to a triangle: its circumcentre, rounded. For pictures and
/// skeletons; nothing is decided by it.
[[nodiscard]] Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c);

}  // namespace tetloft
