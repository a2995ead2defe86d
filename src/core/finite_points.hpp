// Points as they come from outside: refused where a coordinate is not finite.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal {

[[nodiscard]] inline Result<void> check_finite(const Point3& p) {
  if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) return {};
  Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
  error.where.point = p;
  return error;
}
[[nodiscard]] inline Result<void> check_finite(const Point2& p) {
  return check_finite(Point3{p.x, p.y, 0});
}

/// The error names the first one.
template <class Point>
[[nodiscard]] Result<void> check_all_finite(std::span<const Point> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (Result<void> fine = check_finite(points[i]); !fine) {
      Error error = fine.error();
      error.where.vertex = i;
      return error;
    }
  }
  return {};
}

}  // namespace tetloft::internal
