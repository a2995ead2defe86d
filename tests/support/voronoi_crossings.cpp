#include "support/voronoi_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetloft::oracle {

namespace {

Rational cross(const Point2Q& u, const Point2Q& v) { return u.x * v.y - u.y * v.x; }
Point2Q difference(const Point2Q& u, const Point2Q& v) { return {u.x - v.x, u.y - v.y}; }

Point2Q circumcentre_of(const ConformingSection& section, TriangleId t) {
  const PlaneTriangleVertices& v = section.triangulation.triangles[t];
  const Point2Q a = exactly(section.point(v[0]));
  const Point2Q b = difference(exactly(section.point(v[1])), a);
  const Point2Q c = difference(exactly(section.point(v[2])), a);
  const Rational b2 = b.x * b.x + b.y * b.y, c2 = c.x * c.x + c.y * c.y;
  const Rational twice = Rational(2) * cross(b, c);
  return {a.x + (c.y * b2 - b.y * c2) / twice, a.y + (b.x * c2 - c.x * b2) / twice};
}

void set_box(VoronoiEdge& edge) {
  const double x = edge.from.x.approximate(), y = edge.from.y.approximate();
  const double dx = edge.along.x.approximate(), dy = edge.along.y.approximate();
  const double room = 1e-9 * (std::abs(x) + std::abs(y) + std::abs(dx) + std::abs(dy));
  const auto end = [&](double from, double length, int sign) {
    return !edge.ray || sign == 0 ? from + length : sign * std::numeric_limits<double>::infinity();
  };
  const double end_x = end(x, dx, edge.along.x.sign()), end_y = end(y, dy, edge.along.y.sign());
  edge.low_x = std::min(x, end_x) - room;
  edge.high_x = std::max(x, end_x) + room;
  edge.low_y = std::min(y, end_y) - room;
  edge.high_y = std::max(y, end_y) + room;
}

bool is_on(const Point2Q& p, const VoronoiEdge& edge) {
  const Point2Q d = difference(p, edge.from);
  const Rational zero(0);
  if (edge.along == Point2Q{}) return d == Point2Q{};
  if (cross(d, edge.along) != zero) return false;
  const Rational t = d.x * edge.along.x + d.y * edge.along.y;
  return t >= zero && (edge.ray || t <= edge.along.x * edge.along.x + edge.along.y * edge.along.y);
}

bool has_end_on(const VoronoiEdge& p, const VoronoiEdge& q) {
  return is_on(p.from, q) || (!p.ray && is_on({p.from.x + p.along.x, p.from.y + p.along.y}, q));
}

}  // namespace

bool VoronoiEdge::is_far_from(const VoronoiEdge& other) const {
  return high_x < other.low_x || other.high_x < low_x || high_y < other.low_y ||
         other.high_y < low_y;
}

VoronoiEdge voronoi_edge(const ConformingSection& section, EdgeId e) {
  const ConformingSection::Edge& edge = section.edges[e];
  VoronoiEdge dual;
  dual.from = circumcentre_of(section, edge.left.valid() ? edge.left : edge.right);
  dual.ray = !edge.left.valid() || !edge.right.valid();
  if (dual.ray) {
    const Point2Q d = difference(exactly(section.point(edge.b)), exactly(section.point(edge.a)));
    const Rational sign(edge.left.valid() ? 1 : -1);
    dual.along = {sign * d.y, -sign * d.x};
  } else {
    dual.along = difference(circumcentre_of(section, edge.right), dual.from);
  }
  set_box(dual);
  return dual;
}

Meeting meeting_of(const VoronoiEdge& p, const VoronoiEdge& q) {
  const Rational zero(0), one(1);
  const Rational denominator = cross(p.along, q.along);
  // Parallel ones, and those of length zero.
  if (denominator == zero) {
    return has_end_on(p, q) || has_end_on(q, p) ? Meeting::touch : Meeting::apart;
  }
  const Point2Q d = difference(q.from, p.from);
  const Rational s = cross(d, q.along) / denominator;
  const Rational t = cross(d, p.along) / denominator;
  if (s < zero || t < zero || (!p.ray && s > one) || (!q.ray && t > one)) return Meeting::apart;
  const bool inside = s > zero && t > zero && (p.ray || s < one) && (q.ray || t < one);
  return inside ? Meeting::cross : Meeting::touch;
}

bool are_reverse(EdgeKind a, EdgeKind b) {
  return a != EdgeKind::contour && b != EdgeKind::contour &&
         (a == EdgeKind::internal || b == EdgeKind::internal);
}

}  // namespace tetloft::oracle
