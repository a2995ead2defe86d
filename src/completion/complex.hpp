// The complex of a slab: which tets of D each class keeps, and at which corners they are
// attached.
//
// A class keeps a tet only if one of the tet's corners is its own; so at most four classes
// share a tet, and a nibble over the corners holds them all: bit i of `kept` says that the
// class of corner i keeps the tet, bit i of `attached` that the tet belongs to the primary
// sheet of corner i. Corners of one class have equal kept bits; attached implies kept.
#pragma once

#include <cstdint>

#include <tetloft/ids.hpp>

#include "slab/classes.hpp"
#include "slab/rules.hpp"
#include "slab/slab.hpp"

namespace tetloft::internal {

struct Complex {
  IdVector<TetId, std::uint8_t> kept;
  IdVector<TetId, std::uint8_t> attached;

  [[nodiscard]] bool keeps(TetId t, int corner) const { return has_corner(kept[t], corner); }
  [[nodiscard]] bool is_attached(TetId t, int corner) const {
    return has_corner(attached[t], corner);
  }
};

/// A mask of all four corners.
inline constexpr std::uint8_t kAllCorners = 0xF;

/// The corners of t that belong to class c, as a mask.
[[nodiscard]] inline std::uint8_t own_corners(const Slab& slab, const SlabClasses& classes, TetId t,
                                              ClassId c) {
  unsigned mask = 0;
  for (int i = 0; i < 4; ++i) mask |= classes.of(slab.vertex(t, i)) == c ? 1U << i : 0U;
  return static_cast<std::uint8_t>(mask);
}

/// The seed M0 of the active classes: type-1 tets on their internal triangles, type-2 tets
/// with an internal edge of theirs. None may ever go: each is the only filling of an
/// internal edge's ring. Counts tets of two classes.
[[nodiscard]] Complex seed(const Slab& slab, const SlabClasses& classes,
                           const IdVector<ClassId, std::uint8_t>& active, RuleCounts& rules);

}  // namespace tetloft::internal
