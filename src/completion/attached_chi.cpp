#include "completion/attached_chi.hpp"

namespace tetloft::internal {

IdVector<ClassId, std::int32_t> attached_chi(const Slab& slab, const SlabClasses& classes,
                                             const IdVector<ClassId, std::uint8_t>& active,
                                             const Complex& complex) {
  IdVector<ClassId, std::int32_t> chi(classes.class_count(), 0);
  const auto closed = [&](TetId t, unsigned corners) {
    if ((complex.attached[t] & corners) != corners) return false;
    ClassId first;
    for (int i = 0; i < 4; ++i) {
      if (!has_corner(corners, i)) continue;
      const ClassId c = classes.of(slab.vertex(t, i));
      if (first.valid() && c != first) return false;
      first = c;
    }
    return true;
  };
  for (const TetId t : slab.tets()) {
    if (complex.attached[t] == 0) continue;
    if (closed(t, 0xF)) --chi[classes.of(slab.vertex(t, 0))];
    for (int i = 0; i < 4; ++i) {
      if (!closed(t, 0xFU & ~(1U << i))) continue;
      const HalfFaceId h = slab.mesh().opposite(TetMesh::half_face(t, i));
      // Of two tets that close a face the lower one counts it.
      if (h.valid() && TetMesh::tet_of(h) < t &&
          closed(TetMesh::tet_of(h), 0xFU & ~(1U << TetMesh::face_of(h)))) {
        continue;
      }
      ++chi[classes.of(slab.vertex(t, i == 0 ? 1 : 0))];
    }
  }
  // An edge counts at its lower end.
  IdVector<SlabVertexId, SlabVertexId> counted(slab.vertex_count());
  for (const SlabVertexId p : slab.vertices()) {
    const ClassId c = classes.of(p);
    if (active[c] == 0) continue;
    ++chi[c];
    for (const HalfFaceId corner : slab.corners(p)) {
      const TetId t = TetMesh::tet_of(corner);
      const int at = TetMesh::face_of(corner);
      if (!complex.is_attached(t, at)) continue;
      for (int i = 0; i < 4; ++i) {
        const SlabVertexId q = slab.vertex(t, i);
        if (i == at || q < p || !complex.is_attached(t, i) || classes.of(q) != c) continue;
        if (counted[q] == p) continue;
        counted[q] = p;
        --chi[c];
      }
    }
  }
  return chi;
}

}  // namespace tetloft::internal
