// See diagram_edges.hpp.
#include "delaunay3/diagram_edges.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include "core/sort_few.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

struct UpwardEdge {
  PlaneVertexId higher;
  HalfEdgeId half_edge;
};

// Every half-edge that runs from the lower end of its edge to the higher one; none at the ghost.
template <class Visit>
void for_each_upward(const PlaneDiagram& diagram, const Visit& visit) {
  const auto see = [&](HalfEdgeId h) {
    const PlaneVertexId from = diagram.origin(h);
    const PlaneVertexId to = diagram.destination(h);
    if (from < to) visit(h, from, to);
  };
  for (std::size_t k = 0; k < diagram.triangle_count(); ++k) {
    const TriangleId t(k);
    see(PlaneDiagram::half_edge(t, 0));
    if (diagram.is_ghost(t)) continue;
    see(PlaneDiagram::half_edge(t, 1));
    see(PlaneDiagram::half_edge(t, 2));
  }
}

}  // namespace

DiagramEdges::DiagramEdges(const PlaneDiagram& diagram) : edge_(diagram.half_edge_slots()) {
  std::vector<std::uint32_t> end(diagram.vertex_count());  // of the edges of each lower end
  for_each_upward(diagram,
                  [&](HalfEdgeId, PlaneVertexId from, PlaneVertexId) { ++end[from.index()]; });
  std::uint32_t sum = 0;
  for (std::uint32_t& e : end) {
    const std::uint32_t begin = sum;
    sum += e;
    e = begin;
  }
  std::vector<UpwardEdge> upward(sum);
  for_each_upward(diagram, [&](HalfEdgeId h, PlaneVertexId from, PlaneVertexId to) {
    upward[end[from.index()]++] = {to, h};
  });
  half_edge_.reserve(sum);
  std::uint32_t begin = 0;
  for (const std::uint32_t e : end) {
    sort_few(std::span(upward).subspan(begin, e - begin),
             [](const UpwardEdge& a, const UpwardEdge& b) { return a.higher < b.higher; });
    for (; begin < e; ++begin) {
      const HalfEdgeId h = upward[begin].half_edge;
      edge_[h] = edge_[diagram.opposite(h)] = half_edge_.push_back(h);
    }
  }
}

}  // namespace tetloft::internal::delaunay3_detail
