// Arcs of polylines in DXF.
#pragma once

#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::io {

/// Appends the points strictly within the arc from p to q whose bulge, the tangent of a quarter of
/// its angle, counter-clockwise, is `bulge`: by halving until a piece deviates from the arc by less
/// than 1/40 of its length, at most six times; products and roots alone.
void append_arc(const Point3& p, const Point3& q, double bulge, std::vector<Point3>& points);

}  // namespace tetloft::internal::io
