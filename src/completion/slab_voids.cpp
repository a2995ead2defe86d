#include "completion/slab_voids.hpp"

#include "core/guard.hpp"

namespace tetloft::internal {

namespace {

bool is_hole(const Nesting& nesting, ContourId c) { return nesting.depth[c] % 2 != 0; }

}  // namespace

// Vertices are in canonical order: holes are numbered by their lowest ones.
SectionVoids voids_of(const ConformingSection& section) {
  const Nesting& nesting = section.nesting;
  SectionVoids voids;
  voids.of_contour.resize(nesting.region.size());
  for (const ContourId c : section.contour) {
    if (!c.valid() || !is_hole(nesting, c) || voids.of_contour[c].valid()) continue;
    voids.of_contour[c] = RegionId(voids.hole.size());
    voids.hole.push_back(c);
  }
  for (const ContourId c : nesting.region.ids()) {
    if (is_hole(nesting, c)) continue;
    const ContourId around = nesting.parent[c];
    voids.of_contour[c] = around.valid() ? voids.of_contour[around] : RegionId(0);
  }
  return voids;
}

SlabVoids::SlabVoids(const ConformingSection& lower, const ConformingSection& upper,
                     const std::vector<Link>& links)
    : sets_(0) {
  const std::array<SectionVoids, 2> voids{voids_of(lower), voids_of(upper)};
  numbering_ = SlabVoidNumbering(voids[0].hole.size(), voids[1].hole.size());
  sets_ = UnionFind(numbering_.size());
  for (const SectionVoids& of_section : voids) {
    for (const ContourId hole : of_section.hole) hole_.push_back(hole);
  }
  sets_.unite(exterior(false).index(), exterior(true).index());
  for (const Link& link : links) {
    sets_.unite(numbering_.in_slab(false, link.lower).index(),
                numbering_.in_slab(true, link.upper).index());
  }
  number_classes();

  for (const bool upper_plane : {false, true}) {
    const ConformingSection& section = upper_plane ? upper : lower;
    UnionFind pockets(section.internal.size());
    for (const ConformingSection::Edge& edge : section.edges) {
      if (edge.kind != EdgeKind::external || !edge.left.valid() || !edge.right.valid()) continue;
      pockets.unite(edge.left.index(), edge.right.index());
    }
    // Each pocket has a contour edge.
    IdVector<TriangleId, SlabVoidId> of_pocket(section.internal.size());
    for (const ConformingSection::Edge& edge : section.edges) {
      if (edge.kind != EdgeKind::contour) continue;
      for (const TriangleId t : {edge.left, edge.right}) {
        if (!t.valid() || section.internal[t] != 0) continue;
        of_pocket[TriangleId(pockets.find(t.index()))] = numbering_.in_slab(
            upper_plane, voids[upper_plane ? 1 : 0].of_contour[section.contour[edge.a]]);
      }
    }
    auto& of_triangle = of_triangle_[upper_plane ? 1 : 0];
    of_triangle.resize(section.internal.size());
    for (const TriangleId t : of_triangle.ids()) {
      if (section.internal[t] != 0) continue;
      of_triangle[t] = of_pocket[TriangleId(pockets.find(t.index()))];
      TETLOFT_CHECK(of_triangle[t].valid());
    }
  }
}

void SlabVoids::number_classes() {
  class_of_.assign(numbering_.size(), VoidClassId());
  class_count_ = 0;
  for (const SlabVoidId v : class_of_.ids()) {
    // A set's representative is its smallest element, hence numbered before the others.
    const SlabVoidId leader(sets_.find(v.index()));
    class_of_[v] = leader == v ? VoidClassId(class_count_++) : class_of_[leader];
  }
}

void SlabVoids::unite(SlabVoidId a, SlabVoidId b) {
  sets_.unite(a.index(), b.index());
  number_classes();
}

}  // namespace tetloft::internal
