#include "reconstruct/prism.hpp"

#include <algorithm>

namespace tetloft {

IdVector<RegionId, std::vector<TriangleId>> triangles_by_region(const ConformingSection& section) {
  IdVector<RegionId, std::vector<TriangleId>> result(section.nesting.outer.size());
  for (std::size_t k = 0; k < section.internal.size(); ++k) {
    const TriangleId t(k);
    if (section.internal[t] == 0) continue;
    result[section.region[section.triangulation.triangles[t][0]]].push_back(t);
  }
  return result;
}

IdVector<RegionId, std::vector<VertexId>> vertices_by_region(const ConformingSection& section) {
  IdVector<RegionId, std::vector<VertexId>> result(section.nesting.outer.size());
  for (std::size_t v = 0; v < section.vertex_count(); ++v) {
    const RegionId r = section.region[VertexId(v)];
    if (r.valid()) result[r].push_back(VertexId(v));
  }
  return result;
}

void extrude(const ConformingSection& section, const std::vector<TriangleId>& triangles,
             const std::vector<VertexId>& vertices, SlabRegionId region, std::size_t first_base,
             std::size_t first_cap, bool upwards, std::vector<Piece>& pieces) {
  const auto base = [&](VertexId v) { return VertexId(first_base + v.index()); };
  const auto cap = [&](VertexId v) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), v);
    return VertexId(first_cap + static_cast<std::size_t>(at - vertices.begin()));
  };
  for (const TriangleId t : triangles) {
    const auto& [a, b, c] = section.triangulation.triangles[t];
    const std::array<VertexId, 6> prism =
        upwards ? std::array{base(a), base(b), base(c), cap(a), cap(b), cap(c)}
                : std::array{cap(a), cap(b), cap(c), base(a), base(b), base(c)};
    for (const auto& tet : split_prism(prism)) pieces.push_back({tet, region, TetKind::prism});
  }
}

}  // namespace tetloft
