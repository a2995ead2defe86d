// Normals of a surface for smooth shading, in pictures and in files.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal {

/// Unit normals by triangle and corner: the mean of the normals of the triangles around the vertex,
/// weighted by area, over those that lie within kCrease of the triangle's own.
[[nodiscard]] std::vector<std::array<Point3, 3>> corner_normals(
    const std::vector<Point3>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Cosine of 42 degrees: ends and walls stay sharp, facets of a fine contour do not show.
inline constexpr double kCrease = 0.743;

}  // namespace tetloft::internal
