#include "slab/slab.hpp"

#include <bit>
#include <utility>

#include "core/check.hpp"

namespace tetloft {

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
    unsigned mask = 0;
    for (int i = 0; i < 4; ++i) mask |= is_upper(vertex(t, i)) ? 1U << i : 0U;
    upper_corners_[t] = static_cast<std::uint8_t>(mask);
    const int highs = std::popcount(mask);
    TETLOFT_CHECK(highs >= 1 && highs <= 3);
    kind_[t] = highs == 2 ? classify_type2(t) : classify_type1(t, highs == 3);
  }
  // The 2D triangulations are the hull facets of D in their planes, triangle by triangle.
  for (const auto& tet_on : tet_on_) {
    for (const TetId t : tet_on) TETLOFT_CHECK(t.valid());
  }
}

TetKind Slab::classify_type1(TetId t, bool triangle_above) {
  std::array<VertexId, 3> corner;
  std::size_t corners = 0;
  for (int i = 0; i < 4; ++i) {
    if (has_corner(upper_corners_[t], i) == triangle_above) {
      corner[corners++] = in_section(vertex(t, i));
    }
  }
  const ConformingSection& plane = section(triangle_above);
  const TriangleId triangle = plane.find_triangle(corner[0], corner[1], corner[2]);
  TETLOFT_CHECK(triangle.valid());
  TetId& slot = tet_on_[triangle_above ? 1 : 0][triangle];
  TETLOFT_CHECK(!slot.valid());
  slot = t;
  return plane.internal[triangle] != 0 ? TetKind::t1_internal : TetKind::t1_external;
}

TetKind Slab::classify_type2(TetId t) const {
  std::array<std::array<SlabVertexId, 2>, 2> ends;  // below, above
  std::array<std::size_t, 2> found{};
  for (int i = 0; i < 4; ++i) {
    const std::size_t plane = has_corner(upper_corners_[t], i) ? 1 : 0;
    ends[plane][found[plane]++] = vertex(t, i);
  }
  const EdgeKind below = edge_kind(ends[0][0], ends[0][1]);
  const EdgeKind above = edge_kind(ends[1][0], ends[1][1]);
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

}  // namespace tetloft
