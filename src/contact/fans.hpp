// Fans: the triangles at a vertex of high degree. Their boxes all meet there, and long ones meet
// everywhere; as directions from the vertex they lie apart.
//
// A direction box holds the unit vectors from the fan's vertex to a triangle, with some slack. Two
// closed triangles with a common point other than the vertex have a direction in common, so that
// their direction boxes meet; a triangle that holds the vertex itself gets the box of all
// directions, unless it has it as a vertex by id.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/tet_mesh.hpp>

#include "contact/triangle_tree.hpp"

namespace tetloft::internal::contact_detail {

/// The directions from points[apex] to triangle t, of which the apex may be a vertex.
[[nodiscard]] Box directions_of(std::span<const Point3> points, VertexId apex,
                                const TriangleVertices& t);

/// The members of a soup by fans: each triangle with a vertex of high degree belongs to the fan
/// of its vertex of highest degree, the lowest of these; all others to the rest.
struct Fans {
  struct Fan {
    VertexId apex;
    std::vector<std::uint32_t> members;  // by id
  };
  std::vector<Fan> fans;  // by apex
  std::vector<std::uint32_t> rest;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  /// By triangle of the soup: its fan, or kNone. Empty without fans.
  std::vector<std::uint32_t> fan_of;
};

[[nodiscard]] Fans gather_fans(std::size_t vertices, std::span<const TriangleVertices> triangles,
                               std::span<const std::uint32_t> members);

}  // namespace tetloft::internal::contact_detail
