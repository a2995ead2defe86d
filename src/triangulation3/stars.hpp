// Walks around vertices that change nothing, so that several threads may take them at once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <tetloft/ids.hpp>

#include "core/id_set.hpp"
#include "core/prefetch.hpp"
#include "triangulation3/live_tets.hpp"

namespace tetloft::internal::triangulation3 {

/// Visits the tets of v's star once each, ghosts included, each with its vertex that the ones
/// before did not have, or may not have had, until `visit(tet, vertex)` says false; of the first
/// tet all three. Who comes twice comes in tets apart. `seen` is scratch.
template <class Visit>
void for_each_around(const LiveTets& tets, VertexId v, IdSet<TetId>& seen, const Visit& visit) {
  // Tets lie far apart in memory: each is fetched when it is found, and looked at when its turn
  // comes. Of large stars the later ones are looked at when they are found.
  std::array<HalfFaceId, 64> entered;
  const auto shown = [&](HalfFaceId h) {
    const TetId t = TetMesh::tet_of(h);
    return visit(t, tets.tets().tet(t)[h.index() & 3]);
  };
  seen.clear();
  const TetId first = tets.tet_of(v);
  seen.insert(first);
  for (const VertexId u : tets.tets().tet(first)) {
    if (u != v && !visit(first, u)) return;
  }
  for (std::size_t next = 0; next < seen.ids().size(); ++next) {
    const TetId t = seen.ids()[next];
    if (next > 0 && next < entered.size() && !shown(entered[next])) return;
    const std::size_t at = index_of(tets.tets().tet(t), v);
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == at) continue;
      const HalfFaceId across = tets.tets().opposite(half_face(t, i));
      const TetId neighbour = TetMesh::tet_of(across);
      const std::size_t turn = seen.ids().size();
      if (!seen.insert(neighbour)) continue;
      if (turn < entered.size()) {
        core::prefetch(&tets.tets().slot(neighbour));
        entered[turn] = across;
      } else if (!shown(across)) {
        return;
      }
    }
  }
}

/// The tets of v, ghosts included.
[[nodiscard]] inline std::vector<TetId> star_of(const LiveTets& tets, VertexId v) {
  IdSet<TetId> seen;
  for_each_around(tets, v, seen, [](TetId /*t*/, VertexId /*u*/) { return true; });
  return seen.ids();
}

/// The points that are neighbours of v.
[[nodiscard]] inline std::vector<VertexId> neighbours_of(const LiveTets& tets, VertexId v) {
  IdSet<TetId> seen;
  IdSet<VertexId> neighbours;
  for_each_around(tets, v, seen, [&](TetId /*t*/, VertexId u) {
    if (LiveTets::is_point(u)) neighbours.insert(u);
    return true;
  });
  return neighbours.ids();
}

}  // namespace tetloft::internal::triangulation3
