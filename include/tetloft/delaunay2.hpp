// Delaunay triangulations of points, and of points and segments, in the plane.
//
// The unique triangulation of the symbolically perturbed predicates (predicates.hpp): it
// depends on the set of points only, never on input order.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// A triangulation of points in the plane with its Voronoi dual.
struct Triangulation2 {
  IdVector<PlaneVertexId, Point2> points;
  /// Counter-clockwise, each starting at its lowest vertex, sorted. Empty if all points
  /// are collinear.
  IdVector<TriangleId, PlaneTriangleVertices> triangles;
  /// neighbours[t][i] is the triangle across the edge opposite vertex i, or invalid on the
  /// convex hull.
  IdVector<TriangleId, std::array<TriangleId, 3>> neighbours;
};

/// The 2D Delaunay triangulation. Vertices are the input points by index; of duplicates
/// only the lowest index is used. Refused where a coordinate is not finite.
[[nodiscard]] TETLOFT_API Result<Triangulation2> delaunay2(std::span<const Point2> points,
                                                           const Execution& execution = {});

/// A segment to be respected, by the indices of its ends.
using Segment = std::array<PlaneVertexId, 2>;

/// What conforming_delaunay2 inserted.
struct SplitVertex {
  std::size_t segment = 0;  ///< index of the input segment it lies on
  /// Its place among the points inserted into that segment, from the first end, from 0: it
  /// is chains[segment][position + 1].
  std::size_t position = 0;
};

struct ConformingOptions {
  /// segments whose subsegments must be Gabriel: no vertex in or on their diametral
  /// circle but their ends. Empty: none. Otherwise one flag per segment.
  std::vector<bool> gabriel = {};
  /// At most so many points are inserted; 0: 2^16 + 64 (points + segments). Valid sections
  /// come nowhere near it unless hundreds of segments lie side by side, or some at less than
  /// 10^-8 of their length and not along an axis.
  std::size_t most_inserted = 0;
  Execution execution = {};
};

/// conforming_delaunay2 computes with lengths; up to here they do not overflow.
inline constexpr double kLargestSplitCoordinate = 0x1p1000;

/// A Delaunay triangulation in which every segment is a union of edges.
struct Conforming2 {
  /// Points: first the input, then the inserted ones.
  Triangulation2 triangulation;
  /// split[i] describes point n + i, n the number of input points.
  std::vector<SplitVertex> split;
  /// chains[s]: the vertices of segment s from its first to its second end, both included.
  std::vector<std::vector<PlaneVertexId>> chains;
};

/// Splits every segment that is not an edge of the Delaunay triangulation, all of one
/// round together, until none is missing: at the midpoint; where one end makes an angle
/// below 90° with another segment, on concentric shells around that end, at the roundest
/// radius in the middle third (a power of two for the piece at the corner); where both do,
/// first at the midpoint (Ruppert 1995; Shewchuk 2002). If that fails, or without `gabriel`
/// divides a segment into more than 160 pieces, all is done again with splits at the feet of the
/// vertices in a missing piece's diametral circle: at most about as many as segments lie side by
/// side, times their vertices, however close they are.
/// (1) The set of inserted points does not depend on the order of points, segments or ends;
/// a segment set whose segments are all edges is not split. (2) Inserted points are numbered
/// by round, within a round in canonical order. (3) Every inserted point is rounded once and
/// is input from then on: the chain bends by ulps and is what is respected. Whether it is
/// still simple is for the caller to verify.
/// Requires distinct points and segments that do not cross or touch but at shared ends.
/// Fails (invalid_input, naming the vertex) where a coordinate is not finite or beyond
/// kLargestSplitCoordinate, points or segments are repeated, or an end is not a point; and
/// (where.vertex is the first end of the segment, where.point the point) when rounding leaves
/// no room to split (unrepresentable), or most_inserted would be exceeded (work_limit). Segments
/// that cross or touch end there as well, unless a point is inserted just where they meet.
[[nodiscard]] TETLOFT_API Result<Conforming2> conforming_delaunay2(
    std::span<const Point2> points, std::span<const Segment> segments,
    const ConformingOptions& options = {});

/// The Voronoi vertex dual to a triangle: its circumcentre, rounded, the same for any order
/// of a, b, c. Not finite if they are collinear. For pictures and skeletons; nothing is
/// decided by it.
[[nodiscard]] TETLOFT_API Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c);

}  // namespace tetloft
