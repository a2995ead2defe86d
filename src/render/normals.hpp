// Normals for smooth shading.
#pragma once

#include <array>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::render {

struct Subject;

/// corner_normals() of the boundary.
[[nodiscard]] std::vector<std::array<Point3, 3>> smooth_normals(const Subject& subject);

}  // namespace tetloft::internal::render
