// What of D a complex leaves empty, and how it hangs together.
//
// A set of corners of a tet is *closed* if all are attached in this tet, to one class. A tet is
// void, in part at least, unless its four corners are closed. Then
//   two void tets hang together across a face unless its corners are closed in either;
//   a type-1 tet on an external triangle hangs together with the void of that triangle, unless its
//     corners are closed;
//   a type-2 tet with the void of each of its external edges, unless its ends are closed;
//   a tet at a hull facet that lies in no plane with the exterior, unless the facet is closed.
// That is how it is in the solid, too: pieces are what is near attached corners, lifting opens
// nothing, and trimming is a collapse. Prisms, exterior vertices and foreign classes need no rule
// of their own: their corners are never attached to the class.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "completion/complex.hpp"
#include "completion/slab_voids.hpp"

namespace tetloft::internal {

/// Where a void tet hangs together with a void of a plane.
struct VoidContact {
  TetId tet;
  std::uint8_t corners = 0;  ///< of the triangle, edge or facet between
  SlabVoidId with;
};

class VoidSpace {
 public:
  /// All must outlive this; the complex may change.
  VoidSpace(const Slab& slab, const SlabClasses& classes, const SlabVoids& voids,
            const Complex& complex);

  [[nodiscard]] const SlabVoids& voids() const { return voids_; }

  /// Do these corners belong to one class?
  [[nodiscard]] bool of_one_class(TetId t, unsigned corners) const;
  [[nodiscard]] bool is_closed(TetId t, unsigned corners) const {
    return (complex_.attached[t] & corners) == corners && of_one_class(t, corners);
  }
  [[nodiscard]] bool is_void(TetId t) const { return !is_closed(t, 0xF); }
  /// The void tet that t hangs together with across face i; invalid if none.
  [[nodiscard]] TetId next(TetId t, int i) const;

  /// Calls visit(contact) for those of a void tet.
  template <class Visit>
  void for_each_contact(TetId t, const Visit& visit) const {
    if (on_[t].valid()) {
      const unsigned upper = slab_.upper_corners(t);
      const unsigned triangle = std::popcount(upper) == 3 ? upper : ~upper & 0xFU;
      visit_open(t, triangle, on_[t], visit);
    }
    if (std::popcount(unsigned{slab_.upper_corners(t)}) == 2) {
      for (const bool upper : {false, true}) {
        const unsigned edge =
            upper ? unsigned{slab_.upper_corners(t)} : ~unsigned{slab_.upper_corners(t)} & 0xFU;
        const SlabVoidId with = void_at_edge(t, upper, edge);
        if (with.valid()) visit_open(t, edge, with, visit);
      }
    }
    for (int i = 0; i < 4; ++i) {
      if (slab_.mesh().neighbour(t, i).valid()) continue;
      const unsigned facet = 0xFU & ~(1U << i);
      const unsigned upper = slab_.upper_corners(t) & facet;
      if (upper == 0 || upper == facet) continue;
      visit_open(t, facet, voids_.exterior(false), visit);
    }
  }

  /// The void tets that hang together with t, in the order of a search from it. `seen` marks them.
  [[nodiscard]] std::vector<TetId> part_of(TetId t, IdVector<TetId, std::uint8_t>& seen) const;

 private:
  template <class Visit>
  void visit_open(TetId t, unsigned corners, SlabVoidId with, const Visit& visit) const {
    if (!is_closed(t, corners)) visit(VoidContact{t, static_cast<std::uint8_t>(corners), with});
  }
  // Invalid unless the edge is external.
  [[nodiscard]] SlabVoidId void_at_edge(TetId t, bool upper, unsigned edge) const;

  const Slab& slab_;
  const SlabClasses& classes_;
  const SlabVoids& voids_;
  const Complex& complex_;
  IdVector<TetId, SlabVoidId> on_;  // of the external triangle of a type-1 tet
};

}  // namespace tetloft::internal
