#include "sections/rooms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tetloft/delaunay2.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/section_stack.hpp>

#include "core/guard.hpp"
#include "sections/point_segment.hpp"

namespace tetloft::internal::sections {

namespace {

Contour outline_of(const Ring& ring, const Room& room) {
  Contour outline;
  for (const std::size_t k : room.border) outline.vertices.push_back(ring.points[k]);
  return outline;
}

// Strictly, by the edges that a ray in direction x crosses.
bool is_strictly_inside(const Contour& outline, const Point2& p) {
  bool odd = false;
  const std::vector<Point2>& v = outline.vertices;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Point2& a = v[k];
    const Point2& b = v[k + 1 == v.size() ? 0 : k + 1];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const Sign side = orient2d(a, b, p);
    if (side == Sign::zero) return false;
    if ((side == Sign::positive) == (b.y > a.y)) odd = !odd;
  }
  return odd;
}

// The centres of the circles that circumscribe and inscribe a triangle, rounded.
std::array<Point2, 2> centres(const Point2& p, const Point2& q, const Point2& r) {
  const double a = std::sqrt(square_distance(q, r));
  const double b = std::sqrt(square_distance(r, p));
  const double c = std::sqrt(square_distance(p, q));
  const double around = a + b + c;
  const Point2 incentre{(a * p.x + b * q.x + c * r.x) / around,
                        (a * p.y + b * q.y + c * r.y) / around};
  const double qx = q.x - p.x;
  const double qy = q.y - p.y;
  const double rx = r.x - p.x;
  const double ry = r.y - p.y;
  const double twice = 2 * (qx * ry - qy * rx);
  const double q2 = qx * qx + qy * qy;
  const double r2 = rx * rx + ry * ry;
  return {incentre, Point2{p.x + (q2 * ry - r2 * qy) / twice, p.y + (r2 * qx - q2 * rx) / twice}};
}

bool disc_fits(const Contour& outline, const Point2& centre, double width) {
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return false;
  const std::vector<Point2>& v = outline.vertices;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const Point2& b = v[k + 1 == v.size() ? 0 : k + 1];
    if (4 * square_distance(centre, v[k], b) <= width * width) return false;
  }
  return is_strictly_inside(outline, centre);
}

bool holds_contour(const Contour& outline, const OtherEdges& others, std::size_t self) {
  Box2 box;
  for (const Point2& p : outline.vertices) box.add(p);
  bool holds = false;
  others.tree.query(box, [&](std::size_t k) {
    if (holds || others.contour[k] == self) return;
    holds = is_strictly_inside(outline, others.edges[k].a);
  });
  return holds;
}

}  // namespace

// Along the ring a gate is opened at one end and closed at the other, as brackets are.
Rooms part_by_gates(const Ring& ring, const std::vector<Gate>& gates) {
  struct AtPoint {
    std::vector<std::size_t> opened, closed;
  };
  std::vector<AtPoint> at(ring.size());
  for (std::size_t g = 0; g < gates.size(); ++g) {
    at[gates[g].from].opened.push_back(g);
    at[gates[g].to].closed.push_back(g);
  }
  Rooms result;
  result.rooms.resize(gates.size() + 1);
  result.within.resize(gates.size());
  result.beyond.resize(gates.size());
  std::vector<std::size_t> inside{0};  // room 0 is that of the first point
  for (std::size_t k = 0; k < ring.size(); ++k) {
    result.rooms[inside.back()].border.push_back(k);
    std::vector<std::size_t>& opened = at[k].opened;
    std::sort(opened.begin(), opened.end(),
              [&](std::size_t g, std::size_t h) { return gates[g].to > gates[h].to; });
    for (std::size_t n = at[k].closed.size(); n > 0; --n) {
      inside.pop_back();
      result.rooms[inside.back()].border.push_back(k);
    }
    for (const std::size_t g : opened) {
      const std::size_t room = g + 1;
      result.within[g] = room;
      result.beyond[g] = inside.back();
      result.rooms[room].gates.push_back(g);
      result.rooms[inside.back()].gates.push_back(g);
      inside.push_back(room);
      result.rooms[room].border.push_back(k);
    }
  }
  for (Room& room : result.rooms) {
    room.is_outside = area_sign(outline_of(ring, room)) == Sign::positive;
  }
  return result;
}

bool is_narrow(const Ring& ring, const Room& room, const OtherEdges& others, std::size_t self,
               double width) {
  if (room.is_outside) return false;
  const Contour outline = outline_of(ring, room);
  if (holds_contour(outline, others, self)) return false;
  const Result<Triangulation2> triangulation = delaunay2(outline.vertices);
  if (!accepted(triangulation)) return true;  // all on one line
  const auto& points = triangulation->points;
  for (const PlaneTriangleVertices& t : triangulation->triangles) {
    for (const Point2& centre : centres(points[t[0]], points[t[1]], points[t[2]])) {
      if (disc_fits(outline, centre, width)) return false;
    }
  }
  return true;
}

}  // namespace tetloft::internal::sections
