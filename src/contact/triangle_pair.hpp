// One triangle against another, in space.
//
// What is asked of a triangle alone is computed once and kept in its Facing: a coordinate
// plane onto which it projects without degenerating, and whether its own plane is parallel
// to that one. Then the side of a point is a comparison and no determinant; the caps of a
// solid between planar sections are like that. For all others the normal is kept, so that
// the filter of a side is a scalar product and a bound; only what it cannot decide is asked
// of orient3d.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::contact_detail {

using Triangle3 = std::array<Point3, 3>;

/// The coordinate along which a projection looks; none for a degenerate triangle.
enum class Axis : std::uint8_t { x, y, z, none };

struct Facing {
  Axis axis = Axis::none;
  bool parallel = false;  ///< the coordinate `axis` is the same at all three vertices
  /// For the filter of side(): the rounded normal at the triangle's first vertex, and the
  /// largest computed |difference| of the other vertices to it along each axis.
  Point3 normal;
  Point3 reach;
};

[[nodiscard]] Triangle3 corners(std::span<const Point3> points, const TriangleVertices& t);

[[nodiscard]] Facing facing_of(const Triangle3& t);

/// A triangle with all that a quick test needs, side by side in memory.
struct Prepared {
  TriangleVertices vertex;
  Triangle3 corner;
  Facing facing;
  int turn = 0;  ///< its orientation as projected; 0 if not parallel or not certain
};

[[nodiscard]] Prepared prepare(std::span<const Point3> points, const TriangleVertices& t);

/// True only if a and b do not touch: the plane of one, or, in one plane, an edge of one,
/// has all vertices of the other strictly on one side but for those the two share on it.
/// By filters alone; most pairs are decided here.
[[nodiscard]] bool certainly_apart(const Prepared& a, const Prepared& b);

/// The contract of triangles_touch(); f and g are the facings of a and b.
[[nodiscard]] bool touch(std::span<const Point3> points, const TriangleVertices& a, const Facing& f,
                         const TriangleVertices& b, const Facing& g);

}  // namespace tetloft::contact_detail
