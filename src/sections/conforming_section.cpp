// Canonical numbering, the edge table and its look-ups.
#include "sections/conforming_section.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "core/entry.hpp"
#include "core/guard.hpp"
#include "core/sort_few.hpp"
#include "delaunay2/canonical.hpp"
#include "spatial/sort_by_key.hpp"

namespace tetloft {

using namespace internal;

namespace {

// A side of a triangle, by the lower end of its edge.
struct EdgeSide {
  std::uint32_t order;  // twice the higher end, plus one where the triangle lies to the right
  std::uint32_t side;   // 4 t + i, opposite vertex i of triangle t

  [[nodiscard]] PlaneVertexId high() const { return PlaneVertexId(order / 2); }
  [[nodiscard]] bool is_left() const { return (order & 1U) == 0; }
  [[nodiscard]] TriangleId triangle() const { return TriangleId(side / 4); }
  [[nodiscard]] std::size_t opposite() const { return side & 3U; }
};

IdVector<PlaneVertexId, PlaneVertexId> canonical_numbers(std::span<const Point2> points) {
  std::vector<Keyed> order(points.size());
  for (std::uint32_t v = 0; v < order.size(); ++v) order[v].place = v;
  sort_canonically(order, [&](std::uint32_t v) -> const Point2& { return points[v]; });
  IdVector<PlaneVertexId, PlaneVertexId> number(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[PlaneVertexId(order[k].place)] = PlaneVertexId(k);
  }
  return number;
}

std::vector<Point2> renumbered(std::span<const Point2> points,
                               const IdVector<PlaneVertexId, PlaneVertexId>& number) {
  std::vector<Point2> result(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    result[number[PlaneVertexId(v)].index()] = points[v];
  }
  return result;
}

// Triangles in new numbers, each from its lowest vertex, sorted.
IdVector<TriangleId, PlaneTriangleVertices> canonical_triangles(
    const IdVector<TriangleId, PlaneTriangleVertices>& triangles,
    const IdVector<PlaneVertexId, PlaneVertexId>& number) {
  IdVector<TriangleId, PlaneTriangleVertices> result = triangles;
  for (PlaneTriangleVertices& t : result) {
    for (PlaneVertexId& v : t) v = number[v];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

void sort_sides(std::span<EdgeSide> of_vertex) {
  sort_few(of_vertex, [](const EdgeSide& s, const EdgeSide& t) { return s.order < t.order; });
}

// All sides by the lower ends of their edges, those at v up to end[v], sorted: by edge, the left
// side first.
std::vector<EdgeSide> sorted_sides(const IdVector<TriangleId, PlaneTriangleVertices>& triangles,
                                   std::vector<std::uint32_t>& end) {
  for (const PlaneTriangleVertices& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++end[std::min(t[i], t[(i + 1) % 3]).index()];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t begin = sum;
    sum += e;
    e = begin;
  }
  std::vector<EdgeSide> sides(sum);
  for (const TriangleId t : triangles.ids()) {
    const PlaneTriangleVertices& v = triangles[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const PlaneVertexId from = v[(i + 1) % 3];
      const PlaneVertexId to = v[(i + 2) % 3];
      const bool left = from < to;
      const PlaneVertexId low = left ? from : to;
      const PlaneVertexId high = left ? to : from;
      sides[end[low.index()]++] = {2 * high.value() + (left ? 0U : 1U), 4 * t.value() + i};
    }
  }
  std::uint32_t begin = 0;
  for (const std::uint32_t e : end) {
    sort_sides(std::span(sides).subspan(begin, e - begin));
    begin = e;
  }
  return sides;
}

// The neighbours and edges of triangles in their final numbers.
void link_triangles(ConformingSection& section) {
  Triangulation2& own = section.triangulation;
  const std::size_t n = own.points.size();
  own.neighbours.assign(own.triangles.size(), {});
  std::vector<std::uint32_t> end(n);
  const std::vector<EdgeSide> sides = sorted_sides(own.triangles, end);
  section.edges.reserve(sides.size() / 2 + n);
  section.first_edge.assign(n + 1, 0);
  std::size_t k = 0;
  for (std::size_t v = 0; v < n; ++v) {
    while (k < end[v]) {
      const EdgeSide& side = sides[k++];
      ConformingSection::Edge edge{PlaneVertexId(v), side.high(), EdgeKind::external, {}, {}};
      (side.is_left() ? edge.left : edge.right) = side.triangle();
      if (k < end[v] && sides[k].high() == edge.b) {
        const EdgeSide& other = sides[k++];
        TETLOFT_CHECK(side.is_left() && !other.is_left());
        edge.right = other.triangle();
        own.neighbours[side.triangle()][side.opposite()] = other.triangle();
        own.neighbours[other.triangle()][other.opposite()] = side.triangle();
      }
      section.edges.push_back(edge);
    }
    section.first_edge[v + 1] = static_cast<std::uint32_t>(section.edges.size());
  }
}

}  // namespace

IdVector<PlaneVertexId, PlaneVertexId> sections::adopt(
    const delaunay2_detail::ConformedPlane& plane, ConformingSection& section) {
  IdVector<PlaneVertexId, PlaneVertexId> number = canonical_numbers(plane.points);
  std::vector<Point2> points = renumbered(plane.points, number);
  if (plane.start.plane) {
    IdVector<delaunay2_detail::SiteId, PlaneVertexId> name_of(plane.start.input_of.size());
    for (const delaunay2_detail::SiteId v : name_of.ids()) {
      const PlaneVertexId of_input = plane.start.input_of[v];
      if (of_input.valid()) name_of[v] = number[of_input];
    }
    section.triangulation =
        delaunay2_detail::canonical_triangulation(*plane.start.plane, name_of, std::move(points));
  } else {
    section.triangulation.points = IdVector<PlaneVertexId, Point2>(std::move(points));
  }
  link_triangles(section);
  return number;
}

IdVector<PlaneVertexId, PlaneVertexId> sections::adopt(const Triangulation2& triangulation,
                                                       ConformingSection& section) {
  IdVector<PlaneVertexId, PlaneVertexId> number = canonical_numbers(triangulation.points.raw());
  section.triangulation.points =
      IdVector<PlaneVertexId, Point2>(renumbered(triangulation.points.raw(), number));
  section.triangulation.triangles = canonical_triangles(triangulation.triangles, number);
  link_triangles(section);
  return number;
}

IdVector<TriangleId, std::array<EdgeId, 3>> sections::edges_of_sides(
    const ConformingSection& section) {
  IdVector<TriangleId, std::array<EdgeId, 3>> result(section.triangulation.triangles.size());
  for (const EdgeId e : section.edges.ids()) {
    const ConformingSection::Edge& edge = section.edges[e];
    for (const auto& [triangle, from] :
         {std::pair(edge.left, edge.a), std::pair(edge.right, edge.b)}) {
      if (!triangle.valid()) continue;
      // Side i runs from vertex i + 1.
      const PlaneTriangleVertices& v = section.triangulation.triangles[triangle];
      result[triangle][v[0] == from ? 2 : v[1] == from ? 0 : 1] = e;
    }
  }
  return result;
}

Section sections::given_section(const ConformingSection& section) {
  Section given;
  given.z = section.z;
  given.contours.resize(section.nesting.region.size());
  for (const PlaneVertexId first : section.contour.ids()) {
    const ContourId c = section.contour[first];
    if (!c.valid() || !given.contours[c].vertices.empty()) continue;
    PlaneVertexId v = first;
    do {
      if (section.input_vertex[v] != ConformingSection::kNotInput) {
        given.contours[c].vertices.push_back(section.point(v));
      }
      v = section.next[v];
    } while (v != first);
  }
  return given;
}

void sections::classify_edges(ConformingSection& section) {
  for (ConformingSection::Edge& edge : section.edges) {
    if (section.next[edge.a] == edge.b || section.next[edge.b] == edge.a) {
      edge.kind = EdgeKind::contour;
    } else if (edge.left.valid() && section.internal[edge.left] != 0) {
      edge.kind = EdgeKind::internal;
    } else {
      edge.kind = EdgeKind::external;
    }
  }
}

void sections::require_consistent(const ConformingSection& section) {
  const std::size_t vertices = section.triangulation.points.size();
  const std::size_t triangles = section.triangulation.triangles.size();
  const auto is_triangle = [&](TriangleId t) { return !t.valid() || t.index() < triangles; };
  const bool fit =
      section.contour.size() == vertices &&
      std::all_of(
          section.contour.begin(), section.contour.end(),
          [&](ContourId c) { return !c.valid() || c.index() < section.nesting.parent.size(); }) &&
      std::all_of(section.triangulation.triangles.begin(), section.triangulation.triangles.end(),
                  [&](const PlaneTriangleVertices& t) {
                    return std::max({t[0], t[1], t[2]}).index() < vertices;
                  }) &&
      std::all_of(
          section.edges.begin(), section.edges.end(), [&](const ConformingSection::Edge& edge) {
            return edge.a.index() < vertices && edge.b.index() < vertices &&
                   is_triangle(edge.left) && is_triangle(edge.right) &&
                   (edge.kind == EdgeKind::contour || edge.left.valid() || edge.right.valid());
          });
  require_fit(fit, "no section as conform() makes it");
}

EdgeId ConformingSection::find_edge(PlaneVertexId u, PlaneVertexId v) const {
  const PlaneVertexId a = std::min(u, v);
  const PlaneVertexId b = std::max(u, v);
  if (b.index() >= vertex_count()) return {};
  const auto first = edges.begin() + first_edge[a.index()];
  const auto last = edges.begin() + first_edge[a.index() + 1];
  const auto found =
      std::lower_bound(first, last, b, [](const Edge& e, PlaneVertexId end) { return e.b < end; });
  if (found == last || found->b != b) return {};
  return EdgeId(found - edges.begin());
}

TriangleId ConformingSection::find_triangle(PlaneVertexId u, PlaneVertexId v,
                                            PlaneVertexId w) const {
  std::array<PlaneVertexId, 3> sorted{u, v, w};
  std::sort(sorted.begin(), sorted.end());
  const EdgeId id = find_edge(sorted[0], sorted[1]);
  if (!id.valid()) return {};
  for (const TriangleId t : {edges[id].left, edges[id].right}) {
    if (!t.valid()) continue;
    const PlaneTriangleVertices& corners = triangulation.triangles[t];
    if (std::find(corners.begin(), corners.end(), sorted[2]) != corners.end()) return t;
  }
  return {};
}

}  // namespace tetloft
