#include "slab/slab.hpp"

#include <algorithm>
#include <utility>

#include "core/guard.hpp"

namespace tetloft::internal {

Slab::Slab(const ConformingSection& lower, const ConformingSection& upper, SlabDelaunay d)
    : lower_(&lower),
      upper_(&upper),
      numbering_(lower.vertex_count(), upper.vertex_count()),
      mesh_(std::move(d.mesh)),
      base_(std::move(d.base)),
      edges_(std::move(d.edges)),
      tet_on_{IdVector<TriangleId, TetId>(lower.triangulation.triangles.size()),
              IdVector<TriangleId, TetId>(upper.triangulation.triangles.size())} {
  classify_tets();
}

EdgeId Slab::edge(TetId t, int i, int j) const {
  const bool upper = has_corner(upper_corners_[t], i);
  if (base_[t].lower.valid() && base_[t].upper.valid()) return base_edge(upper, t);
  // The third corner of the triangle faces the edge.
  const TriangleId triangle = this->triangle(t);
  const PlaneTriangleVertices& corner = section(upper).triangulation.triangles[triangle];
  const PlaneVertexId a = in_section(vertex(t, i));
  const PlaneVertexId b = in_section(vertex(t, j));
  std::size_t k = 0;
  while (corner[k] == a || corner[k] == b) ++k;
  return edges_[upper ? 1 : 0][triangle][k];
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
    unsigned mask = 0;
    for (int i = 0; i < 4; ++i) mask |= is_upper(vertex(t, i)) ? 1U << i : 0U;
    upper_corners_[t] = static_cast<std::uint8_t>(mask);
    const bool below = base_[t].lower.valid();
    const bool above = base_[t].upper.valid();
    kind_[t] = below && above ? classify_type2(t) : classify_type1(t, above);
  }
  // The 2D triangulations are the hull facets of D in their planes, triangle by triangle.
  for (const auto& tet_on : tet_on_) {
    for (const TetId t : tet_on) TETLOFT_CHECK(t.valid());
  }
}

TetKind Slab::classify_type1(TetId t, bool above) {
  const TriangleId triangle = this->triangle(t);
  for (const PlaneVertexId v : section(above).triangulation.triangles[triangle]) {
    TETLOFT_CHECK(mesh_.index_in(t, mesh_vertex(numbering_.in_slab(above, v))) >= 0);
  }
  TetId& slot = tet_on_[above ? 1 : 0][triangle];
  TETLOFT_CHECK(!slot.valid());
  slot = t;
  return section(above).internal[triangle] != 0 ? TetKind::t1_internal : TetKind::t1_external;
}

TetKind Slab::classify_type2(TetId t) const {
  const ConformingSection::Edge& lower = lower_->edges[base_edge(false, t)];
  const ConformingSection::Edge& upper = upper_->edges[base_edge(true, t)];
  // Canonical: lower vertices first, and the two of a section in order but for the last.
  const TetVertices& v = mesh_.vertices(t);
  TETLOFT_CHECK(v[0] == mesh_vertex(numbering_.in_slab(false, lower.a)) &&
                v[1] == mesh_vertex(numbering_.in_slab(false, lower.b)));
  TETLOFT_CHECK(std::min(v[2], v[3]) == mesh_vertex(numbering_.in_slab(true, upper.a)) &&
                std::max(v[2], v[3]) == mesh_vertex(numbering_.in_slab(true, upper.b)));
  const EdgeKind below = lower.kind;
  const EdgeKind above = upper.kind;
  // By the kinds in the order of EdgeKind: internal, external, contour.
  static constexpr std::array<std::array<TetKind, 3>, 3> kKinds{
      {{TetKind::ii, TetKind::ie, TetKind::ic},
       {TetKind::ie, TetKind::ee, TetKind::ec},
       {TetKind::ic, TetKind::ec, TetKind::cc}}};
  return kKinds[static_cast<std::size_t>(below)][static_cast<std::size_t>(above)];
}

TetId Slab::tet_at_edge(bool in_upper, EdgeId e) const {
  const ConformingSection::Edge& edge = section(in_upper).edges[e];
  const TriangleId triangle = edge.left.valid() ? edge.left : edge.right;
  return tet_on_[in_upper ? 1 : 0][triangle];
}

}  // namespace tetloft::internal
