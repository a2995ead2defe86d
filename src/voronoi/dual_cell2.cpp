#include "voronoi/dual_cell2.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "delaunay2/circle_minors.hpp"
#include "voronoi/cut_polyhedron.hpp"
#include "voronoi/near_one.hpp"

namespace tetloft::internal::voronoi {

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

// With enough digits: of u = 2^-53 and rounded differences the error of the determinant is below
// 8 u times the product of the edges, and of the minors below 8 u times that and the sum of the
// edges, which are at most two radii each. So at this limit the determinant's is below 2^-42 of it,
// and the centre's below (8 u / kFlat) · (1 + 4 / 2) < 2^-40 radii.
delaunay2_detail::CircleMinors circle_minors_within(const std::array<Point3, 3>& p) {
  constexpr double kFlat = 0x1p-8;
  const auto rough = delaunay2_detail::circle_minors(p, [](double u, double v) { return u - v; });
  if (std::abs(rough.determinant) > kFlat * product_of_edges(p)) return rough;
  return delaunay2_detail::circle_minors(
      p, [](double u, double v) { return to_expansion(two_difference(u, v)); });
}

// The triangles around a vertex, counter-clockwise: one turn from the neighbour of lowest index, or
// on the hull from one end to the other.
struct Fan {
  std::vector<DelaunayVertex> vertices;  // one more than triangles on the hull
  std::vector<TriangleId> triangles;     // [k] follows vertices[k]
};

std::size_t place_in(const std::array<DelaunayVertex, 3>& v, DelaunayVertex site) {
  return static_cast<std::size_t>(std::find(v.begin(), v.end(), site) - v.begin());
}

Fan fan_of(const DelaunayTriangulation2& triangulation, DelaunayVertex site,
           DelaunayVertex lowest) {
  const auto place_of = [&](TriangleId t) { return place_in(triangulation.vertices(t), site); };
  const std::array<TriangleId, 2> sides = triangulation.triangles(site, lowest);
  TriangleId first = sides[0].valid() ? sides[0] : sides[1];
  const TriangleId start = first;
  for (;;) {
    const TriangleId before = triangulation.neighbours(first)[(place_of(first) + 2) % 3];
    if (!before.valid()) break;
    first = before;
    if (first == start) break;
  }
  Fan fan;
  TriangleId t = first;
  do {
    const std::size_t i = place_of(t);
    const std::array<DelaunayVertex, 3> v = triangulation.vertices(t);
    fan.triangles.push_back(t);
    fan.vertices.push_back(v[(i + 1) % 3]);
    t = triangulation.neighbours(t)[(i + 1) % 3];
    if (!t.valid()) fan.vertices.push_back(v[(i + 2) % 3]);
  } while (t.valid() && t != first);
  return fan;
}

}  // namespace

Point2 circle_centre_from(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::array<Point3, 3> p{Point3{a.x, a.y, 0}, Point3{b.x, b.y, 0}, Point3{c.x, c.y, 0}};
  const double largest = largest_difference(p);
  if (largest == 0 || !std::isfinite(largest)) return {kNone, kNone};
  const int exponent = bring_near_one(p, largest);
  const delaunay2_detail::CircleMinors found = circle_minors_within(p);
  if (found.determinant == 0) return {kNone, kNone};
  const double twice = 2 * found.determinant;
  return {std::ldexp(found.x / twice, exponent), std::ldexp(found.y / twice, exponent)};
}

VoronoiCell2 dual_cell(const DelaunayTriangulation2& triangulation, DelaunayVertex site,
                       const std::vector<DelaunayVertex>& neighbours) {
  VoronoiCell2 cell;
  cell.site = site;
  cell.bounded = triangulation.dimension() == 2 && !triangulation.is_on_hull(site);
  for (const DelaunayVertex v : neighbours) {
    cell.edges.push_back({.neighbour = v,
                          .side = BoxSide::none,
                          .inside = true,
                          .ends = {VoronoiEdge2::kEndless, VoronoiEdge2::kEndless},
                          .length = kNoEnd});
  }
  cell.area = cell.bounded ? 0 : kNoEnd;
  if (triangulation.dimension() < 2) return cell;
  const Point2& at = triangulation.point(site);
  const Fan fan = fan_of(triangulation, site, neighbours.front());
  const std::size_t n = fan.triangles.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::array<DelaunayVertex, 3> v = triangulation.vertices(fan.triangles[k]);
    const std::size_t i = place_in(v, site);
    cell.corners.push_back(circle_centre_from(at, triangulation.point(v[(i + 1) % 3]),
                                              triangulation.point(v[(i + 2) % 3])));
  }
  for (std::size_t k = 0; k < fan.vertices.size(); ++k) {
    const auto place = std::lower_bound(neighbours.begin(), neighbours.end(), fan.vertices[k]);
    VoronoiEdge2& edge = cell.edges[static_cast<std::size_t>(place - neighbours.begin())];
    if (k > 0 || cell.bounded) edge.ends[0] = static_cast<std::uint32_t>((k + n - 1) % n);
    if (k < n) edge.ends[1] = static_cast<std::uint32_t>(k);
    if (k == n || (k == 0 && !cell.bounded)) continue;
    const Point2& from = cell.corners[edge.ends[0]];
    const Point2& to = cell.corners[edge.ends[1]];
    const Point2& p = triangulation.point(edge.neighbour);
    const HalfSpace half = nearer_to_origin({p.x - at.x, p.y - at.y, 0});
    edge.length = std::max(0.0, half.normal.x * (to.y - from.y) - half.normal.y * (to.x - from.x));
    cell.area += 0.5 * half.offset * edge.length;
  }
  for (Point2& corner : cell.corners) corner = {corner.x + at.x, corner.y + at.y};
  return cell;
}

}  // namespace tetloft::internal::voronoi
