// The crossings of two planes' Voronoi edges: every upper edge traced through the lower cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>

#include "core/watched_work.hpp"
#include "delaunay3/diagram_edges.hpp"
#include "delaunay3/plane_diagram.hpp"

namespace tetloft::internal::delaunay3_detail {

/// The diagrams of the planes that a slab lies between.
struct SlabDiagrams {
  PlaneDiagram lower;
  PlaneDiagram upper;
  DiagramEdges lower_edges;
  DiagramEdges upper_edges;

  SlabDiagrams(const Triangulation2& lower_plane, const Triangulation2& upper_plane);

  /// How many tets have a triangle in one of the planes.
  [[nodiscard]] std::size_t type1_count() const {
    return lower.finite_count() + upper.finite_count();
  }
};

/// Where the Voronoi edge of one plane crosses that of an edge of the other. Seen from the upper
/// Voronoi edge as traced: into the cell of the lower edge's higher end, or into that of its lower
/// end. Planes have fewer than 3 · 2^29 edges, so twice their numbers fit.
class Crossing {
 public:
  [[nodiscard]] static Crossing unpacked(std::uint32_t packed) { return Crossing(packed); }
  [[nodiscard]] std::uint32_t packed() const { return packed_; }
  Crossing(EdgeId lower_edge, bool to_higher)
      : packed_(2 * lower_edge.value() + (to_higher ? 1U : 0U)) {}
  [[nodiscard]] EdgeId edge() const { return EdgeId(packed_ >> 1); }
  [[nodiscard]] bool to_higher() const { return (packed_ & 1U) != 0; }

 private:
  explicit Crossing(std::uint32_t packed) : packed_(packed) {}

  std::uint32_t packed_;
};

struct UpperTrace {
  /// The crossings of one upper Voronoi edge, from the circumcentre to the left of `upper` to that
  /// to its right.
  struct Run {
    HalfEdgeId upper;
    PlaneVertexId left;  // of one who goes along
    PlaneVertexId right;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  std::vector<Crossing> crossings;
  IdVector<EdgeId, Run> run;                          ///< by upper edge
  IdVector<EdgeId, std::uint32_t> count_on_edge;      ///< by lower edge: of its crossings
  IdVector<TriangleId, PlaneVertexId> nearest_below;  ///< to the centre of a finite upper triangle
};

/// Nothing where crossings and triangles together are more than `most_tets`; no more are made.
/// Looks at the stop token of `work`, and tells no step.
[[nodiscard]] std::optional<UpperTrace> trace_upper_edges(const SlabDiagrams& planes,
                                                          const WatchedWork& work,
                                                          std::size_t most_tets);

}  // namespace tetloft::internal::delaunay3_detail
