// Points off the affine hull of others: live_tets.hpp.
#pragma once

#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::triangulation3 {

/// As many points as dimensions are missing, so that these and `points` span space, which
/// dimension + 1 points, affinely independent, do not. Requires at least one.
[[nodiscard]] std::vector<Point3> auxiliary_points(std::span<const Point3> basis);

}  // namespace tetloft::internal::triangulation3
