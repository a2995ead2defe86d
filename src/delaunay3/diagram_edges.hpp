// The edges of a section's diagram, numbered canonically.
#pragma once

#include <cstddef>

#include <tetloft/delaunay2.hpp>
#include <tetloft/ids.hpp>

#include "delaunay3/plane_diagram.hpp"

namespace tetloft::internal::delaunay3_detail {

/// Edges sorted by their lower ends, then by their higher ones; that order is also that of the tets
/// on them. Those at the ghost have no number. Linear.
///
/// Vertices are in order by (x, y). So the edges of a vertex to higher ones lie within less than a
/// half-turn, and the triangles between them, of which it is the lowest vertex, are one fan: each
/// has one such edge for its first side, and there is one edge more than triangles. Triangles are
/// sorted by just these edges.
class DiagramEdges {
 public:
  /// Requires the triangulation that the diagram is of.
  DiagramEdges(const PlaneDiagram& diagram, const Triangulation2& triangulation);

  [[nodiscard]] std::size_t size() const { return half_edge_.size(); }
  [[nodiscard]] auto ids() const { return half_edge_.ids(); }
  [[nodiscard]] EdgeId edge(HalfEdgeId h) const { return edge_[h]; }
  /// From its lower end to its higher one.
  [[nodiscard]] HalfEdgeId half_edge(EdgeId e) const { return half_edge_[e]; }

 private:
  IdVector<HalfEdgeId, EdgeId> edge_;
  IdVector<EdgeId, HalfEdgeId> half_edge_;
};

}  // namespace tetloft::internal::delaunay3_detail
