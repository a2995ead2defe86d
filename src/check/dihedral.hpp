// The dihedral angles of a tet, in plain doubles.
#pragma once

#include <array>

#include <tetloft/point.hpp>

namespace tetloft::internal::checking {

/// At edge e of kEdgeVertex, in degrees; accurate for small angles, too. All 0 for a tet that is
/// not positive. Coordinates are to be near 1: products of three must neither over- nor underflow.
[[nodiscard]] std::array<double, 6> dihedral_degrees(const std::array<Point3, 4>& corner);

}  // namespace tetloft::internal::checking
