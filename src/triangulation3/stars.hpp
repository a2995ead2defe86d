// Walks around vertices that change nothing, so that several threads may take them at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>

#include "core/prefetch.hpp"
#include "triangulation3/live_tets.hpp"

namespace tetloft::internal::triangulation3 {

/// A few ids, each once, in the order in which they came.
template <class IdType>
class IdSet {
 public:
  /// False where it was there.
  bool insert(IdType id) {
    if (ids_.empty()) ids_.reserve(kFirstTable / 2);
    if (2 * (ids_.size() + 1) > mask_ + 1) grow();
    IdType* const table = this->table();
    std::size_t at = place(id);
    for (; table[at].valid(); at = (at + 1) & mask_) {
      if (table[at] == id) return false;
    }
    ids_.push_back(id);
    table[at] = id;
    return true;
  }
  [[nodiscard]] bool contains(IdType id) const {
    const IdType* const table = large_.empty() ? first_.data() : large_.data();
    for (std::size_t at = place(id); table[at].valid(); at = (at + 1) & mask_) {
      if (table[at] == id) return true;
    }
    return false;
  }
  [[nodiscard]] const std::vector<IdType>& ids() const { return ids_; }
  void clear() {
    IdType* const table = this->table();
    for (const IdType id : ids_) {
      for (std::size_t at = place(id); table[at].valid(); at = (at + 1) & mask_) {
        table[at] = IdType();
      }
    }
    ids_.clear();
  }

 private:
  static constexpr std::size_t kFirstTable = 128;  // a star has 27 tets, on average
  [[nodiscard]] std::size_t place(IdType id) const {
    // Fibonacci hashing (Knuth, TAOCP 3, 6.4).
    return static_cast<std::size_t>(id.value() * std::uint64_t{0x9E37'79B9'7F4A'7C15U} >> 32) &
           mask_;
  }
  [[nodiscard]] IdType* table() { return large_.empty() ? first_.data() : large_.data(); }
  void grow() {
    large_.assign(2 * (mask_ + 1), IdType());
    mask_ = large_.size() - 1;
    for (const IdType id : ids_) {
      std::size_t at = place(id);
      while (large_[at].valid()) at = (at + 1) & mask_;
      large_[at] = id;
    }
  }

  std::vector<IdType> ids_;
  // The table, of mask_ + 1 places: in the set itself while it is small, as most stars are.
  std::array<IdType, kFirstTable> first_{};
  std::vector<IdType> large_;
  std::size_t mask_ = kFirstTable - 1;
};

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
