// Exact intersection tests of closed segments and triangles in the plane.
#pragma once

#include <array>

#include <tetloft/point.hpp>

namespace tetloft::internal::contact_detail {

using Segment2 = std::array<Point2, 2>;
using Triangle2 = std::array<Point2, 3>;

/// Closed segments, also where an end or both coincide.
[[nodiscard]] bool segments_meet(const Segment2& s, const Segment2& t);

/// A closed segment, also of length zero, and a closed triangle that is not degenerate.
[[nodiscard]] bool segment_meets_triangle(const Segment2& s, const Triangle2& t);

/// Closed triangles, neither degenerate.
[[nodiscard]] bool triangles_meet(const Triangle2& s, const Triangle2& t);

/// Whether the closed angles at `apex`, from p to q and from u to v, have a common ray.
/// Neither angle is straight or zero.
[[nodiscard]] bool angles_meet(const Point2& apex, const Segment2& pq, const Segment2& uv);

}  // namespace tetloft::internal::contact_detail
