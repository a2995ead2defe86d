// One triangle against another, in space.
//
// What is asked of a triangle alone is computed once and kept in its Facing: a coordinate
// plane onto which it projects without degenerating, and whether its own plane is parallel
// to that one. Then the side of a point is a comparison and no determinant; the caps of a
// solid between planar sections are like that. Else it is an inner product with the normal,
// wherever rounding cannot have changed its sign.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::contact_detail {

using Triangle3 = std::array<Point3, 3>;

/// The coordinate along which a projection looks; none for a degenerate triangle.
enum class Axis : std::uint8_t { x, y, z, none };

struct Facing {
  Axis axis = Axis::none;
  bool parallel = false;  ///< the coordinate `axis` is the same at all three vertices
  Point3 normal{};        ///< (t1 - t0) x (t2 - t0), rounded
  Point3 magnitude{};     ///< for each coordinate of it, that of the products it is made of
};

[[nodiscard]] Triangle3 corners(std::span<const Point3> points, const TriangleVertices& t);

[[nodiscard]] Facing facing_of(const Triangle3& t);

/// Two triangles with the vertices that they share in front of both, in one order.
struct Meeting {
  Meeting(const TriangleVertices& first, const TriangleVertices& second);

  TriangleVertices a, b;
  std::size_t shared = 0;
  bool a_reversed = false;  ///< against the order given: an odd permutation
  bool b_reversed = false;
};

/// The contract of triangles_touch(); f and g are the facings of the pair as given.
[[nodiscard]] bool touch(std::span<const Point3> points, const Meeting& pair, const Facing& f,
                         const Facing& g);

}  // namespace tetloft::internal::contact_detail
