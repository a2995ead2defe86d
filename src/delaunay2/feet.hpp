// Where a piece of a segment is split because of a vertex in its diametral circle.
//
// At the foot of that vertex, its obstacle: between two segments that do not cross, the foot of
// a foot never lies in the circle of a piece that ends at the first, so that vertices pass from
// one segment to the next in columns and each segment gets one point for each column, whatever
// the distance of the segments. (Fixed radii or midpoints of two segments that share no end do
// not agree, and the segments refine each other to length / distance.) Two exceptions:
//
// 1. An obstacle on a segment that shares a corner has its foot moved out to its own radius
//    around the corner. Feet would spiral into a corner whose acute angles close a circle;
//    pieces between equal shells do not encroach upon each other (Ruppert 1995).
// 2. An obstacle at height d over the first d / 2 of the piece, x from its end, would cut off a
//    piece that is short without need. The obstacle is outside the circle of every first piece
//    up to x + d² / x; half of that is taken. So columns that miss each other by the rounding of
//    coordinates cost a piece for d² / rounding of the length, not one for d.
#pragma once

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay2_detail {

/// Part of a segment, with the ends of the whole: a lies before b on the way from `from` to `to`.
struct Piece {
  Point2 from, to;
  Point2 a, b;
};

/// How wide the angle a p b is, for p in the diametral circle of a b: minus its cotangent. It is
/// the same for b and a swapped.
[[nodiscard]] double angle_width(const Point2& a, const Point2& p, const Point2& b);

/// The split point; in the closed box of a and b. `corner`: the end of the segment that the
/// obstacle's own segment shares, or null. Swapping a with b and `from` with `to` changes nothing.
[[nodiscard]] Point2 split_at_foot(const Piece& piece, const Point2& obstacle,
                                   const Point2* corner);

}  // namespace tetloft::internal::delaunay2_detail
