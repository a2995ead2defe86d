// Circles and ellipses of drawings as polygons.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::io {

inline constexpr std::size_t kEllipsePoints = 64;

/// So many points, counter-clockwise, the four extreme ones among them.
[[nodiscard]] std::vector<Point2> ellipse_points(const Point2& centre, double rx, double ry);

}  // namespace tetloft::internal::io
