#include "slab/slab.hpp"

#include <utility>

#include "core/guard.hpp"

namespace tetloft::internal {

Slab::Slab(const ConformingSection& lower, const ConformingSection& upper, TetMesh mesh)
    : lower_(&lower),
      upper_(&upper),
      numbering_(lower.vertex_count(), upper.vertex_count()),
      mesh_(std::move(mesh)),
      tet_on_{IdVector<TriangleId, TetId>(lower.triangulation.triangles.size()),
              IdVector<TriangleId, TetId>(upper.triangulation.triangles.size())} {
  classify_tets();
}

EdgeKind Slab::edge_kind(SlabVertexId u, SlabVertexId v) const {
  const EdgeId e = edge(u, v);
  TETLOFT_CHECK(e.valid());
  return section_of(u).edges[e].kind;
}

void Slab::classify_tets() {
  kind_.resize(tet_count());
  upper_corners_.resize(tet_count());
  for (const TetId t : tets()) {
    std::array<Corners, 2> plane;  // below, above
    unsigned mask = 0;
    for (int i = 0; i < 4; ++i) {
      const SlabVertexId v = vertex(t, i);
      const unsigned upper = is_upper(v) ? 1 : 0;
      mask |= upper << i;
      plane[upper].add(in_section(v));
    }
    upper_corners_[t] = static_cast<std::uint8_t>(mask);
    const bool above = plane[1].count > 2;
    kind_[t] = plane[0].count == 2 ? classify_type2(plane[0], plane[1])
                                   : classify_type1(t, plane[above ? 1 : 0], above);
  }
  // The 2D triangulations are the hull facets of D in their planes, triangle by triangle.
  for (const auto& tet_on : tet_on_) {
    for (const TetId t : tet_on) TETLOFT_CHECK(t.valid());
  }
}

TetKind Slab::classify_type1(TetId t, const Corners& corners, bool above) {
  TETLOFT_CHECK(corners.count == 3);
  const ConformingSection& plane = section(above);
  const TriangleId triangle = plane.find_triangle(corners.id[0], corners.id[1], corners.id[2]);
  TETLOFT_CHECK(triangle.valid());
  TetId& slot = tet_on_[above ? 1 : 0][triangle];
  TETLOFT_CHECK(!slot.valid());
  slot = t;
  return plane.internal[triangle] != 0 ? TetKind::t1_internal : TetKind::t1_external;
}

TetKind Slab::classify_type2(const Corners& lower, const Corners& upper) const {
  const EdgeId e = lower_->find_edge(lower.id[0], lower.id[1]);
  const EdgeId f = upper_->find_edge(upper.id[0], upper.id[1]);
  TETLOFT_CHECK(e.valid() && f.valid());
  const EdgeKind below = lower_->edges[e].kind;
  const EdgeKind above = upper_->edges[f].kind;
  const auto has = [&](EdgeKind k) { return below == k || above == k; };
  if (has(EdgeKind::internal)) {
    if (below == above) return TetKind::ii;
    return has(EdgeKind::external) ? TetKind::ie : TetKind::ic;
  }
  if (has(EdgeKind::external)) return below == above ? TetKind::ee : TetKind::ec;
  return TetKind::cc;
}

TetId Slab::tet_at_edge(bool in_upper, EdgeId e) const {
  const ConformingSection::Edge& edge = section(in_upper).edges[e];
  const TriangleId triangle = edge.left.valid() ? edge.left : edge.right;
  return tet_on_[in_upper ? 1 : 0][triangle];
}

}  // namespace tetloft::internal
