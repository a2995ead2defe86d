// The walk through a triangulation to where a point lies.
#pragma once

#include <cstddef>
#include <cstdint>

#include <tetloft/ids.hpp>

#include "core/guard.hpp"
#include "delaunay3/growing_tets.hpp"

namespace tetloft::internal::delaunay3_detail {

/// From tet to tet towards a point: a tet whose closure contains it, or a ghost tet whose hull
/// facet it lies strictly beyond; invalid where the walk comes to a tet that `use` does not own.
/// `is_beyond(vertices, i)`: does the point lie strictly beyond face i of such a tet? `from` is
/// finite; `state` is that of a generator, whatever it was left at.
///
/// Remembering visibility walk (Devillers, Pion and Teillaud, "Walking in a triangulation",
/// IJFCS 13, 2002). It ends in every Delaunay triangulation, the perturbed ones included: the power
/// of the point decreases with each tet. The first face tried is drawn at random for speed alone.
template <class Use, class IsBeyond>
TetId walk(const GrowingTets& tets, TetId from, std::uint32_t& state, const Use& use,
           const IsBeyond& is_beyond) {
  TetId t = from;
  std::size_t entered = 4;
  for (std::size_t steps = 0;; ++steps) {
    TETLOFT_CHECK(steps <= tets.taken());
    state = state * 1664525U + 1013904223U;
    const TetSlot& slot = tets.slot(t);
    HalfFaceId crossing;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t i = ((state >> 30) + k) & 3U;
      if (i == entered) continue;
      if (!is_beyond(slot.vertices, i)) continue;
      crossing = slot.opposite[i];
      break;
    }
    if (!crossing.valid()) return t;
    t = TetMesh::tet_of(crossing);
    if (tets.is_ghost(t)) return t;
    if (!use.owns(tets, t)) return TetId();
    entered = static_cast<std::size_t>(TetMesh::face_of(crossing));
  }
}

}  // namespace tetloft::internal::delaunay3_detail
