// Normals for smooth shading.
#pragma once

#include <array>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::render {

struct Subject;

/// By boundary face and corner: the mean of the normals of the faces around the vertex, weighted by
/// area, over those that lie within kCrease of the face's own.
[[nodiscard]] std::vector<std::array<Point3, 3>> smooth_normals(const Subject& subject);

/// Cosine of 42 degrees: ends and walls stay sharp, facets of a fine contour do not show.
inline constexpr double kCrease = 0.743;

}  // namespace tetloft::internal::render
