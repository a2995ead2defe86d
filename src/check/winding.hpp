// Winding numbers of a closed surface, exactly: how many tets lie over one another just
// outside each of its components.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::checking {

/// winding[c]: the winding number of the whole surface about points just off the outer
/// side of component c, next to its first triangle that is not vertical. For the boundary
/// surface of positive tets it is the number of tets that contain such a point. 0 for a
/// component with vertical triangles only, which no closed embedded surface has.
///
/// Requires non-degenerate triangles, oriented outward, without contact. Near-linear for
/// triangles of similar size.
[[nodiscard]] std::vector<long> outer_winding(std::span<const Point3> points,
                                              std::span<const TriangleVertices> triangles,
                                              std::span<const std::uint32_t> component,
                                              std::size_t component_count);

}  // namespace tetloft::internal::checking
