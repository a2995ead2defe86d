// The canonical names of an engine's tets, worked out in its slots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "delaunay3/stretches.hpp"
#include "delaunay3/tet_slot.hpp"

namespace tetloft::internal::delaunay3_detail {

/// So many slots before one is worked on what it leads to is fetched.
inline constexpr std::size_t kSlotsAhead = 16;

/// The slots' stretches.
[[nodiscard]] Stretches stretches_of(std::span<const TetSlot> built);

/// A slot between the engine's numbering and the canonical one. Its vertices are ranks in canonical
/// order, but for the first, the lowest rank, which the name of the tet replaces once it has one.
/// Above vertex k, in two bits: to which place the engine's vertex k went.
namespace renamed {

inline constexpr unsigned kRankBits = 30;
inline constexpr std::uint32_t kRankMask = (1U << kRankBits) - 1;
/// Ghosts and dead slots keep what they have for vertex 0, the two largest numbers; no name comes
/// so high.
inline constexpr std::size_t kMostTets = kRankMask - 1;

/// Neither ghost nor dead.
[[nodiscard]] inline bool is_finite(const TetSlot& slot) {
  return slot.vertices[0].value() < 0xFFFFFFFEU;
}
[[nodiscard]] inline std::uint32_t rank(const TetSlot& slot, std::size_t k) {
  return slot.vertices[k].value() & kRankMask;
}
/// Of a slot whose tet has its name.
[[nodiscard]] inline std::uint32_t name(const TetSlot& slot) { return rank(slot, 0); }
/// The canonical place of the engine's vertex k, and so of its face k.
[[nodiscard]] inline std::uint32_t place(const TetSlot& slot, std::size_t k) {
  return slot.vertices[k].value() >> kRankBits;
}

}  // namespace renamed

/// Gives every finite tet its name; there are at most renamed::kMostTets. Returns where the tets of
/// each lowest rank begin, and their number: begin[r] to begin[r + 1].
[[nodiscard]] std::vector<std::uint32_t> name_tets(std::span<TetSlot> built,
                                                   std::span<const std::uint32_t> rank_of,
                                                   unsigned threads);

}  // namespace tetloft::internal::delaunay3_detail
