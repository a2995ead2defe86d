#include "contact/planar.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::contact_detail {

namespace {

bool ranges_meet(double a, double b, double c, double d) {
  return std::min(a, b) <= std::max(c, d) && std::min(c, d) <= std::max(a, b);
}

// Whether all points are strictly on the given side of line pq.
bool all_on_side(const Point2& p, const Point2& q, std::span<const Point2> points, Sign wanted) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Point2& x) { return orient2d(p, q, x) == wanted; });
}

// Whether the line through some edge of t has all points strictly beyond it.
bool edge_separates(const Triangle2& t, std::span<const Point2> points) {
  const Sign outside = -orient2d(t[0], t[1], t[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (all_on_side(t[k], t[(k + 1) % 3], points, outside)) return true;
  }
  return false;
}

bool ray_in_angle(const Point2& apex, const Segment2& pq, const Point2& x) {
  const Sign turn = orient2d(apex, pq[0], pq[1]);
  return orient2d(apex, pq[0], x) != -turn && orient2d(apex, x, pq[1]) != -turn;
}

}  // namespace

bool segments_meet(const Segment2& s, const Segment2& t) {
  // The boxes decide where all four points are collinear.
  if (!ranges_meet(s[0].x, s[1].x, t[0].x, t[1].x)) return false;
  if (!ranges_meet(s[0].y, s[1].y, t[0].y, t[1].y)) return false;
  const Sign a = orient2d(s[0], s[1], t[0]);
  if (a != Sign::zero && a == orient2d(s[0], s[1], t[1])) return false;
  const Sign b = orient2d(t[0], t[1], s[0]);
  return b == Sign::zero || b != orient2d(t[0], t[1], s[1]);
}

// Disjoint convex polygons are strictly separated along an edge of one of them: the
// difference of the two polygons is a convex polygon without the origin, and its edges are
// parallel to theirs.

bool segment_meets_triangle(const Segment2& s, const Triangle2& t) {
  return !edge_separates(t, s) && !all_on_side(s[0], s[1], t, Sign::positive) &&
         !all_on_side(s[0], s[1], t, Sign::negative);
}

bool triangles_meet(const Triangle2& s, const Triangle2& t) {
  return !edge_separates(s, t) && !edge_separates(t, s);
}

bool angles_meet(const Point2& apex, const Segment2& pq, const Segment2& uv) {
  // What they have in common is bounded by two of the four rays, which lie in both: by u and
  // v, or else by p or q.
  return ray_in_angle(apex, pq, uv[0]) || ray_in_angle(apex, uv, pq[0]) ||
         ray_in_angle(apex, uv, pq[1]);
}

}  // namespace tetloft::internal::contact_detail
