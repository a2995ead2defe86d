// Canonical numbering, the edge table and its look-ups.
#include "sections/conforming_section.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/entry.hpp"
#include "core/guard.hpp"

namespace tetloft {

using namespace internal;

namespace {

// A side of a triangle, seen from the lower end of its edge.
struct EdgeSide {
  PlaneVertexId a, b;  // a < b
  TriangleId triangle;
  std::uint8_t opposite;  // the triangle's vertex that is not on the edge
  bool left;              // the triangle lies to the left of a → b
};

IdVector<PlaneVertexId, PlaneVertexId> canonical_numbers(
    const IdVector<PlaneVertexId, Point2>& points) {
  std::vector<PlaneVertexId> order(points.size());
  for (std::size_t v = 0; v < order.size(); ++v) order[v] = PlaneVertexId(v);
  std::sort(order.begin(), order.end(), [&](PlaneVertexId u, PlaneVertexId v) {
    const Point2& p = points[u];
    const Point2& q = points[v];
    return p == q ? u < v : canonical_less(p, q);
  });
  IdVector<PlaneVertexId, PlaneVertexId> number(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = PlaneVertexId(k);
  return number;
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

// All sides sorted by edge, the left side of an edge first.
std::vector<EdgeSide> sorted_sides(const IdVector<TriangleId, PlaneTriangleVertices>& triangles,
                                   std::size_t vertices) {
  std::vector<std::uint32_t> first(vertices + 1, 0);
  for (const PlaneTriangleVertices& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++first[std::min(t[(i + 1) % 3], t[(i + 2) % 3]).index() + 1];
    }
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<EdgeSide> sides(first.back());
  std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const PlaneTriangleVertices& v = triangles[TriangleId(t)];
    for (std::uint8_t i = 0; i < 3; ++i) {
      const PlaneVertexId from = v[(i + 1U) % 3];
      const PlaneVertexId to = v[(i + 2U) % 3];
      const bool left = from < to;
      const PlaneVertexId low = left ? from : to;
      sides[end[low.index()]++] = {low, left ? to : from, TriangleId(t), i, left};
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) {
    std::sort(sides.begin() + first[v], sides.begin() + first[v + 1],
              [](const EdgeSide& s, const EdgeSide& t) {
                return s.b != t.b ? s.b < t.b : s.left > t.left;
              });
  }
  return sides;
}

}  // namespace

IdVector<PlaneVertexId, PlaneVertexId> sections::adopt(const Triangulation2& triangulation,
                                                       ConformingSection& section) {
  const std::size_t n = triangulation.points.size();
  IdVector<PlaneVertexId, PlaneVertexId> number = canonical_numbers(triangulation.points);
  Triangulation2& own = section.triangulation;
  own.points.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    own.points[number[PlaneVertexId(v)]] = triangulation.points[PlaneVertexId(v)];
  }
  own.triangles = canonical_triangles(triangulation.triangles, number);
  own.neighbours.resize(own.triangles.size());

  const std::vector<EdgeSide> sides = sorted_sides(own.triangles, n);
  section.edges.reserve(sides.size() / 2 + n);
  section.first_edge.assign(n + 1, 0);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const EdgeSide& side = sides[k];
    ConformingSection::Edge edge{side.a, side.b, EdgeKind::external, {}, {}};
    (side.left ? edge.left : edge.right) = side.triangle;
    if (k + 1 < sides.size() && sides[k + 1].a == side.a && sides[k + 1].b == side.b) {
      const EdgeSide& other = sides[++k];
      TETLOFT_CHECK(side.left && !other.left);
      edge.right = other.triangle;
      own.neighbours[side.triangle][side.opposite] = other.triangle;
      own.neighbours[other.triangle][other.opposite] = side.triangle;
    }
    section.edges.push_back(edge);
    ++section.first_edge[side.a.index() + 1];
  }
  std::partial_sum(section.first_edge.begin(), section.first_edge.end(),
                   section.first_edge.begin());
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
