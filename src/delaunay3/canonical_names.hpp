// The canonical names of an engine's tets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "delaunay3/tet_slot.hpp"

namespace tetloft::internal::delaunay3_detail {

/// By slot, apart from the slots: a cache line of names answers for sixteen tets, and of neighbours
/// nothing else is asked.
struct CanonicalNames {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// kNone for ghosts and dead slots.
  std::vector<std::uint32_t> name;
  /// At bits 2 k and 2 k + 1 the canonical place of the engine's vertex k, and so of its face k.
  std::vector<std::uint8_t> places;
  /// The tets of lowest rank r are named begin[r] to begin[r + 1].
  std::vector<std::uint32_t> begin;

  [[nodiscard]] std::size_t tets() const { return begin.back(); }
  [[nodiscard]] std::uint32_t place(std::size_t slot, std::size_t k) const {
    return (places[slot] >> (2 * k)) & 3U;
  }
};

/// Names every finite tet, and leaves for the vertices in its slot their ranks in canonical order.
[[nodiscard]] CanonicalNames name_tets(std::span<TetSlot> built,
                                       std::span<const std::uint32_t> rank_of, unsigned threads);

}  // namespace tetloft::internal::delaunay3_detail
