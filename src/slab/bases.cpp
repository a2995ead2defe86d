#include "slab/bases.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "sections/conforming_section.hpp"

namespace tetloft::internal {

namespace {

using delaunay3_detail::side_of;
using delaunay3_detail::TriangleSideId;

TriangleSideId side_with(const EdgesOfSides& edges, const ConformingSection& section, EdgeId e) {
  const ConformingSection::Edge& edge = section.edges[e];
  const TriangleId t = edge.left.valid() ? edge.left : edge.right;
  std::size_t i = 0;
  while (edges[t][i] != e) ++i;
  return side_of(t, i);
}

}  // namespace

SlabDelaunay with_bases(const ConformingSection& lower, const ConformingSection& upper,
                        TetMesh mesh) {
  SlabDelaunay result;
  result.edges = {sections::edges_of_sides(lower), sections::edges_of_sides(upper)};
  result.base.resize(mesh.tet_slots());
  for (const TetId t : result.base.ids()) {
    std::array<std::array<PlaneVertexId, 4>, 2> corner;
    std::array<std::size_t, 2> corners{};
    for (const VertexId v : mesh.vertices(t)) {
      const std::size_t plane = v.index() < lower.vertex_count() ? 0 : 1;
      corner[plane][corners[plane]++] =
          PlaneVertexId(v.index() - (plane == 1 ? lower.vertex_count() : 0));
    }
    const auto base_in = [&](std::size_t plane) -> TriangleSideId {
      const ConformingSection& section = plane == 1 ? upper : lower;
      const auto& [a, b, c, d] = corner[plane];
      if (corners[plane] == 2) {
        return side_with(result.edges[plane], section, section.find_edge(a, b));
      }
      return corners[plane] == 3 ? side_of(section.find_triangle(a, b, c), 0) : TriangleSideId();
    };
    result.base[t] = {base_in(0), base_in(1)};
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace tetloft::internal
