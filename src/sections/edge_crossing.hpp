// Where a plane of constant z crosses a segment in space.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::sections {

/// The point at height z of the segment from `low` to `high`: its exact x and y, each rounded once
/// to the nearest double. Requires low.z < z <= high.z, and magnitudes below kLargestCoordinate.
[[nodiscard]] Point2 crossing_at(const Point3& low, const Point3& high, double z);

}  // namespace tetloft::internal::sections
