#include "completion/void_space.hpp"

namespace tetloft::internal {

VoidSpace::VoidSpace(const Slab& slab, const SlabClasses& classes, const SlabVoids& voids,
                     const Complex& complex)
    : slab_(slab), classes_(classes), voids_(voids), complex_(complex), on_(slab.tet_count()) {
  for (const bool upper : {false, true}) {
    const ConformingSection& section = slab.section(upper);
    for (const TriangleId t : section.internal.ids()) {
      if (section.internal[t] == 0) on_[slab.tet_on(upper, t)] = voids.at(upper, t);
    }
  }
}

bool VoidSpace::of_one_class(TetId t, unsigned corners) const {
  ClassId first;
  for (int i = 0; i < 4; ++i) {
    if (!has_corner(corners, i)) continue;
    const ClassId c = classes_.of(slab_.vertex(t, i));
    if (!first.valid()) first = c;
    if (c != first) return false;
  }
  return true;
}

TetId VoidSpace::next(TetId t, int i) const {
  const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
  if (!h.valid()) return {};
  const TetId across = TetMesh::tet_of(h);
  if (!is_void(across) || is_closed(t, 0xFU & ~(1U << i)) ||
      is_closed(across, 0xFU & ~(1U << TetMesh::face_of(h)))) {
    return {};
  }
  return across;
}

SlabVoidId VoidSpace::void_at_edge(TetId t, bool upper, unsigned edge) const {
  const EdgeId in_section = slab_.edge(t, std::countr_zero(edge), 31 - std::countl_zero(edge));
  const ConformingSection::Edge& e = slab_.section(upper).edges[in_section];
  return e.kind == EdgeKind::external ? voids_.at(upper, e) : SlabVoidId();
}

std::vector<TetId> VoidSpace::part_of(TetId t, IdVector<TetId, std::uint8_t>& seen) const {
  std::vector<TetId> part{t};
  seen[t] = 1;
  for (std::size_t at = 0; at < part.size(); ++at) {
    for (int i = 0; i < 4; ++i) {
      const TetId across = next(part[at], i);
      if (!across.valid() || seen[across] != 0) continue;
      seen[across] = 1;
      part.push_back(across);
    }
  }
  return part;
}

}  // namespace tetloft::internal
