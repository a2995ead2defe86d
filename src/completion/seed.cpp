#include <bit>

#include "completion/complex.hpp"

namespace tetloft::internal {

namespace {

// Marks the class of corner i as keeping t.
void keep_for_corner(const Slab& slab, const SlabClasses& classes,
                     const IdVector<ClassId, std::uint8_t>& active, TetId t, int corner,
                     std::uint8_t& mask) {
  const ClassId c = classes.of(slab.vertex(t, corner));
  if (active[c] != 0) mask = static_cast<std::uint8_t>(mask | own_corners(slab, classes, t, c));
}

}  // namespace

Complex seed(const Slab& slab, const SlabClasses& classes,
             const IdVector<ClassId, std::uint8_t>& active, RuleCounts& rules) {
  Complex complex;
  complex.kept.assign(slab.tet_count(), 0);
  complex.attached.assign(slab.tet_count(), 0);
  for (const TetId t : slab.tets()) {
    const TetKind kind = slab.kind(t);
    std::uint8_t mask = 0;
    if (kind == TetKind::t1_internal) {
      // The triangle's corners are the three in one plane.
      const bool triangle_above = std::popcount(slab.upper_corners(t)) == 3;
      int corner = 0;
      while (has_corner(slab.upper_corners(t), corner) != triangle_above) ++corner;
      keep_for_corner(slab, classes, active, t, corner, mask);
    } else if (kind == TetKind::ii || kind == TetKind::ie || kind == TetKind::ic) {
      for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
          if (!slab.same_plane(t, i, j)) continue;
          const ConformingSection& section = slab.section(has_corner(slab.upper_corners(t), i));
          if (section.edges[slab.edge(t, i, j)].kind != EdgeKind::internal) continue;
          keep_for_corner(slab, classes, active, t, i, mask);
        }
      }
    }
    complex.kept[t] = mask;
    if (kind == TetKind::ii && mask != 0) {
      ClassId first;
      for (int i = 0; i < 4; ++i) {
        if (!has_corner(mask, i)) continue;
        const ClassId c = classes.of(slab.vertex(t, i));
        if (!first.valid()) first = c;
        if (c != first) {
          count(rules, Rule::two_class_tet);
          break;
        }
      }
    }
  }
  return complex;
}

}  // namespace tetloft::internal
