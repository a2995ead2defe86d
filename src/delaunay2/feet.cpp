#include "delaunay2/feet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delaunay2/shells.hpp"

namespace tetloft::internal::delaunay2_detail {

namespace {

/// Differences of points in units of a power of two: their products neither overflow nor, for
/// obstacles that doubles tell from the segment, vanish.
struct Frame {
  int exponent;

  Frame(const Point2& a, const Point2& b)
      : exponent(std::ilogb(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)))) {}
  [[nodiscard]] Point2 difference(const Point2& p, const Point2& q) const {
    return {std::ldexp(p.x - q.x, -exponent), std::ldexp(p.y - q.y, -exponent)};
  }
  [[nodiscard]] Point2 moved(const Point2& p, const Point2& by) const {
    return {p.x + std::ldexp(by.x, exponent), p.y + std::ldexp(by.y, exponent)};
  }
};

double dot(const Point2& u, const Point2& v) { return u.x * v.x + u.y * v.y; }
double cross(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }
Point2 times(double t, const Point2& u) { return {t * u.x, t * u.y}; }
Point2 plus(const Point2& u, const Point2& v) { return {u.x + v.x, u.y + v.y}; }
double length(const Point2& u) { return std::sqrt(dot(u, u)); }

double clamped(double t, double a, double b) {
  return std::clamp(t, std::min(a, b), std::max(a, b));
}

/// The point of the segment with the same coordinate as `p` along the segment's longer axis, in
/// the closed box of a and b. The coordinate is kept, for columns parallel to an axis; the other
/// is computed from the nearer end, so that it is off by ulps of its own.
Point2 onto(const Point2& p, const Point2& from, const Point2& to, const Point2& a,
            const Point2& b) {
  const Point2 whole{to.x - from.x, to.y - from.y};
  if (std::abs(whole.x) >= std::abs(whole.y)) {
    const double x = clamped(p.x, a.x, b.x);
    const Point2& end = std::abs(x - from.x) <= std::abs(x - to.x) ? from : to;
    return {x, clamped(end.y + (x - end.x) * (whole.y / whole.x), a.y, b.y)};
  }
  const double y = clamped(p.y, a.y, b.y);
  const Point2& end = std::abs(y - from.y) <= std::abs(y - to.y) ? from : to;
  return {clamped(end.x + (y - end.y) * (whole.x / whole.y), a.x, b.x), y};
}

}  // namespace

double angle_width(const Point2& a, const Point2& p, const Point2& b) {
  const Frame frame(a, b);
  const Point2 to_a = frame.difference(a, p);
  const Point2 to_b = frame.difference(b, p);
  const double height = std::abs(cross(to_a, to_b));
  return height > 0 ? -dot(to_a, to_b) / height : std::numeric_limits<double>::infinity();
}

Point2 split_at_foot(const Piece& piece, const Point2& obstacle, const Point2* corner) {
  const bool forward = canonical_less(piece.from, piece.to);
  const Point2& from = forward ? piece.from : piece.to;
  const Point2& to = forward ? piece.to : piece.from;
  const Point2& a = forward ? piece.a : piece.b;
  const Point2& b = forward ? piece.b : piece.a;

  const Frame frame(from, to);
  Point2 along = frame.difference(to, from);
  along = times(1 / length(along), along);
  const double from_a = dot(along, frame.difference(obstacle, a));
  const double to_b = dot(along, frame.difference(b, obstacle));
  // Relative to the nearer end of the segment, so that what is small is told exactly.
  const bool near_from =
      length(frame.difference(obstacle, from)) < length(frame.difference(obstacle, to));
  const double height = cross(along, frame.difference(obstacle, near_from ? from : to));
  const double d = std::abs(height);
  const double near = std::min(from_a, to_b);

  double shift = 0;  // of the foot along the segment, away from the corner
  if (corner != nullptr) {
    const Point2 arm = frame.difference(obstacle, *corner);
    const double radius = length(arm);
    shift = d * (d / (radius + std::abs(dot(along, arm))));
    if (*corner == to) shift = -shift;
  }
  const bool at_corner = corner != nullptr && *corner == (from_a < to_b ? a : b);
  if (at_corner || std::min(from_a + shift, to_b - shift) >= d / 2) {
    const Point2 step = plus(times(-height, Point2{-along.y, along.x}), times(shift, along));
    const Point2 foot = onto(frame.moved(obstacle, step), from, to, a, b);
    if (lies_between(a, foot, b)) return foot;
  }
  const double whole = from_a + to_b;
  const double reach = near > 0 ? (near + d * (d / near)) / 2 : whole;
  if (!(reach < whole / 2)) return midpoint(a, b);
  const Point2 first =
      from_a < to_b ? frame.moved(a, times(reach, along)) : frame.moved(b, times(-reach, along));
  return onto(first, from, to, a, b);
}

}  // namespace tetloft::internal::delaunay2_detail
