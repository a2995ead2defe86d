// The cases of two triangles, by the number of vertices they share.
//
// In each the question is reduced to closed segments against closed triangles, and to the
// plane where all is coplanar. That a segment meets a triangle follows from orientations
// alone: Guigue and Devillers, "Fast and robust triangle-triangle overlap test using
// orientation predicates", JGT 8, 2003; the reductions for shared vertices are ours.
#include "contact/triangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <tetloft/predicates.hpp>

#include "contact/contact.hpp"
#include "contact/planar.hpp"

namespace tetloft::internal::contact_detail {

namespace {

using Segment3 = std::array<Point3, 2>;
using Sides = std::array<Sign, 3>;

double coordinate(const Point3& p, Axis axis) {
  return axis == Axis::x ? p.x : axis == Axis::y ? p.y : p.z;
}

Point2 project(const Point3& p, Axis axis) {
  switch (axis) {
    case Axis::x: return {p.y, p.z};
    case Axis::y: return {p.z, p.x};
    default: return {p.x, p.y};
  }
}

Segment2 project(const Segment3& s, Axis axis) {
  return {project(s[0], axis), project(s[1], axis)};
}

Triangle2 project(const Triangle3& t, Axis axis) {
  return {project(t[0], axis), project(t[1], axis), project(t[2], axis)};
}

// The axes, that of the largest normal coordinate first. Rounding may misjudge which is
// the largest; that costs time only.
std::array<Axis, 3> axes_by_normal(const Triangle3& t) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const double x = std::abs(u.y * v.z - u.z * v.y);
  const double y = std::abs(u.z * v.x - u.x * v.z);
  const double z = std::abs(u.x * v.y - u.y * v.x);
  std::array<Axis, 3> axes{Axis::z, Axis::y, Axis::x};
  if (y > z && y >= x) {
    axes = {Axis::y, Axis::z, Axis::x};
  } else if (x > z) {
    axes = {Axis::x, Axis::z, Axis::y};
  }
  return axes;
}

// A triangle that is not degenerate.
struct Plate {
  const Triangle3& t;
  const Facing& facing;
};

// The side of the plate's plane on which p lies; which side is positive depends on the
// plate alone.
Sign side(const Plate& plate, const Point3& p) {
  if (!plate.facing.parallel) return orient3d(plate.t[0], plate.t[1], plate.t[2], p);
  const double level = coordinate(plate.t[0], plate.facing.axis);
  const double at = coordinate(p, plate.facing.axis);
  if (at == level) return Sign::zero;
  return at > level ? Sign::positive : Sign::negative;
}

bool segment_meets_plate(const Segment3& s, Sign side0, Sign side1, const Plate& plate) {
  const Triangle3& t = plate.t;
  if (side0 == side1) {
    if (side0 != Sign::zero) return false;
    const Axis axis = plate.facing.axis;
    return segment_meets_triangle(project(s, axis), project(t, axis));
  }
  // Line s crosses the plane once, at a point of s; it passes the triangle's edges all on
  // one side iff that point is in the closed triangle.
  bool positive = false;
  bool negative = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign turn = orient3d(s[0], s[1], t[k], t[(k + 1) % 3]);
    positive = positive || turn == Sign::positive;
    negative = negative || turn == Sign::negative;
    if (positive && negative) return false;
  }
  return true;
}

bool segment_meets_plate(const Segment3& s, const Plate& plate) {
  return segment_meets_plate(s, side(plate, s[0]), side(plate, s[1]), plate);
}

bool any_edge_meets(const Triangle3& t, const Sides& sides, const Plate& plate) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    if (segment_meets_plate({t[k], t[l]}, sides[k], sides[l], plate)) return true;
  }
  return false;
}

bool strictly_one_side(const Sides& s) {
  return s[0] != Sign::zero && s[0] == s[1] && s[0] == s[2];
}

Sides sides_of(const Triangle3& t, const Plate& plate) {
  return {side(plate, t[0]), side(plate, t[1]), side(plate, t[2])};
}

bool touch_sharing_nothing(const Plate& a, const Plate& b) {
  const Sides a_sides = sides_of(a.t, b);
  if (strictly_one_side(a_sides)) return false;
  if (a_sides == Sides{}) {
    const Axis axis = b.facing.axis;
    return triangles_meet(project(a.t, axis), project(b.t, axis));
  }
  const Sides b_sides = sides_of(b.t, a);
  if (strictly_one_side(b_sides)) return false;
  // The common points form a segment or a point; each end is on an edge of a or of b.
  return any_edge_meets(a.t, a_sides, b) || any_edge_meets(b.t, b_sides, a);
}

// a and b have their shared vertex first.
bool touch_sharing_vertex(const Plate& a, const Plate& b) {
  const Sign a1 = side(b, a.t[1]);
  const Sign a2 = side(b, a.t[2]);
  if (a1 != Sign::zero && a1 == a2) return false;
  if (a1 == Sign::zero && a2 == Sign::zero) {
    const Axis axis = b.facing.axis;
    return angles_meet(project(a.t[0], axis), project(Segment3{a.t[1], a.t[2]}, axis),
                       project(Segment3{b.t[1], b.t[2]}, axis));
  }
  const Sign b1 = side(a, b.t[1]);
  const Sign b2 = side(a, b.t[2]);
  if (b1 != Sign::zero && b1 == b2) return false;
  // The common points form a segment from the shared vertex; its other end, if it has
  // length, is where it leaves a or b, through the edge opposite the shared vertex.
  return segment_meets_plate({a.t[1], a.t[2]}, a1, a2, b) ||
         segment_meets_plate({b.t[1], b.t[2]}, b1, b2, a);
}

// a and b have their shared vertices first and second.
bool touch_sharing_edge(const Plate& a, const Plate& b) {
  if (side(b, a.t[2]) != Sign::zero) return false;
  const Triangle2 p = project(a.t, b.facing.axis);
  const Triangle2 q = project(b.t, b.facing.axis);
  return orient2d(p[0], p[1], p[2]) == orient2d(q[0], q[1], q[2]);
}

// The segment or point that a degenerate triangle is.
Segment3 hull_of_collinear(const Triangle3& t) {
  const auto [low, high] = std::minmax_element(
      t.begin(), t.end(), [](const Point3& p, const Point3& q) { return canonical_less(p, q); });
  return {*low, *high};
}

// Projections along all three axes meet iff the coplanar segments do: one of the three is
// injective on their common plane, line or point.
bool segments_meet_in_space(const Segment3& s, const Segment3& t) {
  return orient3d(s[0], s[1], t[0], t[1]) == Sign::zero &&
         segments_meet(project(s, Axis::x), project(t, Axis::x)) &&
         segments_meet(project(s, Axis::y), project(t, Axis::y)) &&
         segments_meet(project(s, Axis::z), project(t, Axis::z));
}

bool touch_degenerate(const Plate& a, const Plate& b) {
  if (a.facing.axis != Axis::none) return segment_meets_plate(hull_of_collinear(b.t), a);
  if (b.facing.axis != Axis::none) return segment_meets_plate(hull_of_collinear(a.t), b);
  return segments_meet_in_space(hull_of_collinear(a.t), hull_of_collinear(b.t));
}

}  // namespace

Triangle3 corners(std::span<const Point3> points, const TriangleVertices& t) {
  return {points[t[0].index()], points[t[1].index()], points[t[2].index()]};
}

Facing facing_of(const Triangle3& t) {
  for (const Axis axis : axes_by_normal(t)) {
    const Triangle2 p = project(t, axis);
    if (orient2d(p[0], p[1], p[2]) == Sign::zero) continue;
    const double level = coordinate(t[0], axis);
    const bool parallel = coordinate(t[1], axis) == level && coordinate(t[2], axis) == level;
    return {axis, parallel};
  }
  return {};
}

std::size_t bring_shared_forward(TriangleVertices& a, TriangleVertices& b) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[i], a[shared]);
      std::swap(b[j], b[shared]);
      ++shared;
      break;
    }
  }
  return shared;
}

bool touch(std::span<const Point3> points, std::size_t shared, const TriangleVertices& a,
           const Facing& f, const TriangleVertices& b, const Facing& g) {
  const Triangle3 ta = corners(points, a);
  const Triangle3 tb = corners(points, b);
  const Plate pa{ta, f};
  const Plate pb{tb, g};
  if (f.axis == Axis::none || g.axis == Axis::none) return touch_degenerate(pa, pb);
  switch (shared) {
    case 0: return touch_sharing_nothing(pa, pb);
    case 1: return touch_sharing_vertex(pa, pb);
    case 2: return touch_sharing_edge(pa, pb);
    default: return true;
  }
}

}  // namespace tetloft::internal::contact_detail

namespace tetloft::internal {

bool triangles_touch(std::span<const Point3> points, const TriangleVertices& a,
                     const TriangleVertices& b) {
  using contact_detail::corners;
  using contact_detail::facing_of;
  TriangleVertices first = a;
  TriangleVertices second = b;
  const std::size_t shared = contact_detail::bring_shared_forward(first, second);
  return contact_detail::touch(points, shared, first, facing_of(corners(points, a)), second,
                               facing_of(corners(points, b)));
}

}  // namespace tetloft::internal
