// Exact contact of triangles in space, and of all pairs of a triangle soup.
//
// Two triangles that share vertices (by id) may touch in exactly the simplex they share;
// any further common point is a contact. Decided by orient3d and orient2d alone.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal {

/// True iff the closed triangles a and b, vertices by id into `points`, have a common
/// point outside the simplex spanned by their shared vertices. Distinct ids with equal
/// coordinates are distinct vertices (and thus a contact). Three shared vertices, the same
/// triangle twice, are a contact. A degenerate triangle (collinear, checked exactly) is in
/// contact with whatever its closed segment or point meets, sharing vertices or not.
/// (1) Symmetric in a and b. (2) Independent of the order of vertices in a triangle.
[[nodiscard]] bool triangles_touch(std::span<const Point3> points, const TriangleVertices& a,
                                   const TriangleVertices& b);

/// A pair of triangles in contact, by index, first < second.
struct Contact {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  friend auto operator<=>(const Contact&, const Contact&) = default;
};

/// All contacts of a soup, sorted, at most `limit` (the lowest). Near-linear for
/// triangles of similar size: a bounding-volume tree over the triangles' boxes. Where
/// `active` is not empty, only pairs with active[first] or active[second] nonzero count:
/// after a change, flag the changed triangles. Adds the pairs that boxes did not tell apart, nor
/// sheets, to `tested`, if given.
[[nodiscard]] std::vector<Contact> find_contacts(std::span<const Point3> points,
                                                 std::span<const TriangleVertices> triangles,
                                                 std::size_t limit = static_cast<std::size_t>(-1),
                                                 std::span<const std::uint8_t> active = {},
                                                 std::uint64_t* tested = nullptr);

}  // namespace tetloft::internal
