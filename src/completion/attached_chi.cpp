#include "completion/attached_chi.hpp"

#include <array>
#include <bit>

namespace tetloft::internal {

namespace {

using Chi = IdVector<ClassId, std::int32_t>;

class AttachedChi {
 public:
  AttachedChi(const Slab& slab, const SlabClasses& classes, const Complex& complex)
      : slab_(slab), classes_(classes), complex_(complex), chi_(classes.class_count(), 0) {}

  void count_tets_and_faces() {
    for (const TetId t : slab_.tets()) {
      const unsigned attached = complex_.attached[t];
      if (std::popcount(attached) < 3) continue;
      const std::array<ClassId, 4> c{
          classes_.of(slab_.vertex(t, 0)), classes_.of(slab_.vertex(t, 1)),
          classes_.of(slab_.vertex(t, 2)), classes_.of(slab_.vertex(t, 3))};
      if (attached == 0xF && c[0] == c[1] && c[0] == c[2] && c[0] == c[3]) --chi_[c[0]];
      for (int i = 0; i < 4; ++i) {
        const unsigned face = 0xFU & ~(1U << i);
        if ((attached & face) != face) continue;
        const std::size_t a = i == 0 ? 1 : 0;
        const std::size_t b = i <= 1 ? 2 : 1;
        const std::size_t d = i <= 2 ? 3 : 2;
        if (c[a] == c[b] && c[a] == c[d] && !is_closed_lower(t, i)) ++chi_[c[a]];
      }
    }
  }

  // An edge counts at its lower end.
  void count_vertices_and_edges(const IdVector<ClassId, std::uint8_t>& active) {
    IdVector<SlabVertexId, SlabVertexId> counted(slab_.vertex_count());
    for (const SlabVertexId p : slab_.vertices()) {
      const ClassId c = classes_.of(p);
      if (active[c] == 0) continue;
      std::int32_t edges = 0;
      for (const HalfFaceId corner : slab_.corners(p)) {
        const TetId t = TetMesh::tet_of(corner);
        const int at = TetMesh::face_of(corner);
        const unsigned attached = complex_.attached[t];
        if (!has_corner(attached, at)) continue;
        for (unsigned others = attached & ~(1U << at); others != 0; others &= others - 1) {
          const SlabVertexId q = slab_.vertex(t, std::countr_zero(others));
          if (q < p || counted[q] == p || classes_.of(q) != c) continue;
          counted[q] = p;
          ++edges;
        }
      }
      chi_[c] += 1 - edges;
    }
  }

  [[nodiscard]] const Chi& chi() const { return chi_; }

 private:
  // Is the face closed in the tet across, too, and that the lower one? Then it is counted there.
  [[nodiscard]] bool is_closed_lower(TetId t, int i) const {
    const HalfFaceId h = slab_.mesh().opposite(TetMesh::half_face(t, i));
    if (!h.valid() || !(TetMesh::tet_of(h) < t)) return false;
    const unsigned face = 0xFU & ~(1U << TetMesh::face_of(h));
    return (complex_.attached[TetMesh::tet_of(h)] & face) == face;
  }

  const Slab& slab_;
  const SlabClasses& classes_;
  const Complex& complex_;
  Chi chi_;
};

}  // namespace

IdVector<ClassId, std::int32_t> attached_chi(const Slab& slab, const SlabClasses& classes,
                                             const IdVector<ClassId, std::uint8_t>& active,
                                             const Complex& complex) {
  AttachedChi attached(slab, classes, complex);
  attached.count_tets_and_faces();
  attached.count_vertices_and_edges(active);
  return attached.chi();
}

}  // namespace tetloft::internal
