// See diagram_edges.hpp.
#include "delaunay3/diagram_edges.hpp"

#include <cstdint>

#include "core/guard.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// Of every vertex that is no triangle's lowest its edge to a higher one, from there; there is one
// at most, and triangles have it opposite their lowest vertex.
IdVector<PlaneVertexId, HalfEdgeId> lone_edges(const PlaneDiagram& diagram) {
  IdVector<PlaneVertexId, HalfEdgeId> result(diagram.vertex_count());
  for (std::size_t k = 0; k < diagram.finite_count(); ++k) {
    const HalfEdgeId h = PlaneDiagram::half_edge(TriangleId(k), 0);
    const PlaneVertexId from = diagram.origin(h);
    const PlaneVertexId to = diagram.destination(h);
    if (from < to) {
      result[from] = h;
    } else {
      result[to] = diagram.opposite(h);
    }
  }
  return result;
}

}  // namespace

DiagramEdges::DiagramEdges(const PlaneDiagram& diagram, const Triangulation2& triangulation)
    : edge_(diagram.half_edge_slots()) {
  const auto& triangles = triangulation.triangles;
  const IdVector<PlaneVertexId, HalfEdgeId> lone = lone_edges(diagram);
  const std::size_t hull = diagram.triangle_count() - triangles.size();
  const std::size_t count = (3 * triangles.size() + hull) / 2;
  half_edge_.reserve(count);
  const auto add = [&](HalfEdgeId upward) {
    TETLOFT_CHECK(!edge_[upward].valid());
    edge_[upward] = edge_[diagram.opposite(upward)] = half_edge_.push_back(upward);
  };
  std::size_t begin = 0;
  for (const PlaneVertexId v : triangulation.points.ids()) {
    std::size_t end = begin;
    while (end < triangles.size() && triangles[TriangleId(end)][0] == v) ++end;
    if (begin == end) {
      if (lone[v].valid()) add(lone[v]);
      continue;
    }
    // The last triangle of the fan has no other behind its third side.
    TriangleId last(begin);
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t behind = triangulation.neighbours[TriangleId(k)][1].index();
      if (behind < begin || behind >= end) last = TriangleId(k);
    }
    std::size_t place = begin;
    while (place < end && triangles[TriangleId(place)][1] < triangles[last][2]) ++place;
    for (std::size_t k = begin; k <= end; ++k) {
      add(k == place
              ? diagram.opposite(PlaneDiagram::half_edge(diagram.place_of(last), 1))
              : PlaneDiagram::half_edge(diagram.place_of(TriangleId(k < place ? k : k - 1)), 2));
    }
    begin = end;
  }
  TETLOFT_CHECK(half_edge_.size() == count);
}

}  // namespace tetloft::internal::delaunay3_detail
