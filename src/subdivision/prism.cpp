#include "subdivision/prism.hpp"

#include <algorithm>

namespace tetloft::internal {

IdVector<RegionId, std::vector<TriangleId>> triangles_by_region(const ConformingSection& section) {
  IdVector<RegionId, std::vector<TriangleId>> result(section.nesting.outer.size());
  for (const TriangleId t : section.internal.ids()) {
    if (section.internal[t] == 0) continue;
    result[section.region[section.triangulation.triangles[t][0]]].push_back(t);
  }
  return result;
}

IdVector<RegionId, std::vector<PlaneVertexId>> vertices_by_region(
    const ConformingSection& section) {
  IdVector<RegionId, std::vector<PlaneVertexId>> result(section.nesting.outer.size());
  for (const PlaneVertexId v : section.region.ids()) {
    const RegionId r = section.region[v];
    if (r.valid()) result[r].push_back(v);
  }
  return result;
}

void extrude(const ConformingSection& section, const std::vector<TriangleId>& triangles,
             const std::vector<PlaneVertexId>& vertices, SlabRegionId region,
             const PrismNodes& prism, std::vector<Piece>& pieces) {
  const auto base = [&](PlaneVertexId v) { return Nodes::of(prism.slab.in_slab(prism.upper, v)); };
  const auto cap = [&](PlaneVertexId v) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
    return prism.nodes.of(
        CapId(prism.first_cap.index() + static_cast<std::size_t>(at - vertices.begin())));
  };
  for (const TriangleId t : triangles) {
    const auto& [a, b, c] = section.triangulation.triangles[t];
    const std::array<NodeId, 6> nodes =
        prism.upper ? std::array{cap(a), cap(b), cap(c), base(a), base(b), base(c)}
                    : std::array{base(a), base(b), base(c), cap(a), cap(b), cap(c)};
    for (const auto& tet : split_prism(nodes)) pieces.push_back({tet, region, TetKind::prism});
  }
}

}  // namespace tetloft::internal
