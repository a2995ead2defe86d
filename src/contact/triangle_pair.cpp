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

// Far above the products of coordinates that underflow, 2^-1074, and of no account beside others.
constexpr double kTinyProduct = 0x1p-960;

// Of a triangle's plane: the normal, and how large the products are that it is made of.
void set_normal(const Triangle3& t, Facing& facing) {
  const Point3 u{t[1].x - t[0].x, t[1].y - t[0].y, t[1].z - t[0].z};
  const Point3 v{t[2].x - t[0].x, t[2].y - t[0].y, t[2].z - t[0].z};
  const auto coordinate_of = [](double plus, double minus, double& normal, double& magnitude) {
    normal = plus - minus;
    magnitude = std::abs(plus) + std::abs(minus) + kTinyProduct;
  };
  coordinate_of(u.y * v.z, u.z * v.y, facing.normal.x, facing.magnitude.x);
  coordinate_of(u.z * v.x, u.x * v.z, facing.normal.y, facing.magnitude.y);
  coordinate_of(u.x * v.y, u.y * v.x, facing.normal.z, facing.magnitude.z);
}

// The axes, that of the largest normal coordinate first. Rounding may misjudge which is
// the largest; that costs time only.
std::array<Axis, 3> axes_by_normal(const Point3& normal) {
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
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
  bool reversed;  // t has the vertices in the other order than when it was faced
};

// The sign of the inner product of the normal with p - o, where o is a vertex: zero if it is not
// certain.
//
// Each of the six monomials of the exact product, one from each coordinate of both sides, is
// rounded at most eight times on its way (two differences, a product and a difference in the
// normal, a difference in p - o, a product, two sums), so that the error is at most (1 + u)^8 - 1
// times the sum of their magnitudes. Nine u are more by an eighth, which is far above terms of
// second order and the dozen roundings of that sum and of the bound. Underflow: of products in the
// normal kTinyProduct is ahead, whatever they are multiplied by; of all others kTiny. Where
// anything overflows the sum does as well, and nothing is certain.
Sign certain_side(const Facing& facing, const Point3& o, const Point3& p) {
  constexpr double kNineRoundings = 9 * 0x1p-53;
  constexpr double kTiny = 0x1p-1000;
  const Point3 w{p.x - o.x, p.y - o.y, p.z - o.z};
  const double value = facing.normal.x * w.x + facing.normal.y * w.y + facing.normal.z * w.z;
  const double sum = facing.magnitude.x * std::abs(w.x) + facing.magnitude.y * std::abs(w.y) +
                     facing.magnitude.z * std::abs(w.z);
  const double error = kNineRoundings * sum + kTiny;
  if (value > error) return Sign::positive;
  return value < -error ? Sign::negative : Sign::zero;
}

// The side of the plate's plane on which p lies; which side is positive depends on the
// plate alone.
Sign side(const Plate& plate, const Point3& p) {
  if (!plate.facing.parallel) {
    const Sign sign = certain_side(plate.facing, plate.t[0], p);
    if (sign == Sign::zero) return orient3d(plate.t[0], plate.t[1], plate.t[2], p);
    return plate.reversed ? -sign : sign;
  }
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
  Facing facing;
  set_normal(t, facing);
  for (const Axis axis : axes_by_normal(facing.normal)) {
    const Triangle2 p = project(t, axis);
    if (orient2d(p[0], p[1], p[2]) == Sign::zero) continue;
    const double level = coordinate(t[0], axis);
    facing.axis = axis;
    facing.parallel = coordinate(t[1], axis) == level && coordinate(t[2], axis) == level;
    return facing;
  }
  return facing;
}

Meeting::Meeting(const TriangleVertices& first, const TriangleVertices& second)
    : a(first), b(second) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[i], a[shared]);
      std::swap(b[j], b[shared]);
      a_reversed = a_reversed != (i != shared);
      b_reversed = b_reversed != (j != shared);
      ++shared;
      break;
    }
  }
}

bool touch(std::span<const Point3> points, const Meeting& pair, const Facing& f, const Facing& g) {
  const Triangle3 ta = corners(points, pair.a);
  const Triangle3 tb = corners(points, pair.b);
  const Plate pa{ta, f, pair.a_reversed};
  const Plate pb{tb, g, pair.b_reversed};
  if (f.axis == Axis::none || g.axis == Axis::none) return touch_degenerate(pa, pb);
  switch (pair.shared) {
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
  return contact_detail::touch(points, contact_detail::Meeting(a, b), facing_of(corners(points, a)),
                               facing_of(corners(points, b)));
}

}  // namespace tetloft::internal
