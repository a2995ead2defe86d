// Where a point lies relative to the circle on a segment as diameter, exactly.
#pragma once

#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>

namespace tetloft::internal::delaunay2_detail {

/// The sign of (a − v) · (b − v), exact for all finite coordinates: positive iff the angle
/// at v is acute, zero iff it is right or v is a or b.
/// (1) Swapping a and b changes nothing. (2) For v other than a and b: positive iff v lies
/// outside the circle with diameter a b, zero iff on it (Thales).
[[nodiscard]] Sign angle_sign(const Point2& a, const Point2& v, const Point2& b);

/// True iff v lies in or on the circle with diameter a b. Requires v other than a and b.
[[nodiscard]] inline bool in_diametral_circle(const Point2& a, const Point2& b, const Point2& v) {
  return angle_sign(a, v, b) != Sign::positive;
}

}  // namespace tetloft::internal::delaunay2_detail
