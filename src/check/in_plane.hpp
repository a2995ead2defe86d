// The part of a model that lies in the section planes, as a 2D complex: the faces of tets
// with all three vertices in one plane, with their edges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/view.hpp"

namespace tetloft::internal::checking {

/// An in-plane face, once, however many tets have it.
struct InPlaneTriangle {
  std::size_t plane = 0;
  TriangleVertices vertices;  ///< counter-clockwise; in sorted order if flat
  bool flat = false;          ///< its vertices are collinear
  std::uint32_t below = 0;    ///< number of tets with the fourth vertex below the plane
  std::uint32_t above = 0;
  std::uint32_t within = 0;  ///< and in the plane itself
};

struct InPlaneComplex {
  std::vector<InPlaneTriangle> triangles;  ///< by plane and sorted vertices

  /// An edge of the triangles that are not flat: how many have it on their left when it is
  /// run through from low to high vertex, and how many on their right.
  struct Edge {
    VertexId low, high;
    std::uint32_t left = 0;
    std::uint32_t right = 0;
  };
  std::vector<Edge> edges;  ///< by (low, high)
  /// edges[first_edge[v]] … edges[first_edge[v + 1] − 1] have v as their low end.
  std::vector<std::uint32_t> first_edge;

  /// Is there such an edge? In either order.
  [[nodiscard]] bool has_edge(VertexId a, VertexId b) const;
};

/// Of the planes of these sections.
[[nodiscard]] InPlaneComplex in_plane_complex(const ModelView& view, const SectionRange& sections);

}  // namespace tetloft::internal::checking
