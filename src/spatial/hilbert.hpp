// Places along Hilbert curves, several levels at a time by a table.
//
// A curve in a cube of 2^d cells enters at one corner and leaves along one axis; with these
// two, `entry` and `axis`, go the entries and axes of the curves in its 2^d halves.
// (Hamilton, "Compact Hilbert indices", Dalhousie University CS-2006-07, 2006, sections 2
// and 3: Gray code order, entry points, directions.)
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace tetloft::internal {

namespace hilbert_detail {

/// The curves of all orientations, `levels` levels deep.
template <unsigned dimension, unsigned levels>
struct Table {
  static constexpr std::uint32_t kCorners = 1U << dimension;
  static constexpr std::uint32_t kStates = dimension * kCorners;
  static constexpr std::uint32_t kCells = 1U << (dimension * levels);

  /// By state and cell, coordinate after coordinate from the highest bits: the place, and above
  /// it the state of the curve within.
  std::array<std::uint16_t, std::size_t{kStates} * kCells> entry{};

  static_assert(kStates * kCells <= (1U << 16));

  static constexpr std::uint32_t rotated_right(std::uint32_t bits, unsigned by) {
    by %= dimension;
    return ((bits >> by) | (bits << (dimension - by))) & (kCorners - 1);
  }
  static constexpr std::uint32_t gray(std::uint32_t i) { return i ^ (i >> 1); }

  constexpr Table() {
    for (std::uint32_t state = 0; state < kStates; ++state) {
      for (std::uint32_t cell = 0; cell < kCells; ++cell) {
        std::uint32_t entry_corner = state % kCorners;
        unsigned axis = state / kCorners;
        std::uint32_t place = 0;
        for (unsigned level = levels; level-- > 0;) {
          std::uint32_t corner = 0;
          for (unsigned k = 0; k < dimension; ++k) {
            corner |= ((cell >> ((dimension - 1 - k) * levels + level)) & 1U) << k;
          }
          const std::uint32_t code = rotated_right(corner ^ entry_corner, axis + 1);
          std::uint32_t w = 0;  // the inverse of the Gray code
          for (std::uint32_t rest = code; rest != 0; rest >>= 1) w ^= rest;
          place = (place << dimension) | w;
          const std::uint32_t local_entry = w == 0 ? 0 : gray((w - 1) & ~1U);
          entry_corner ^= rotated_right(local_entry, dimension - (axis + 1) % dimension);
          const unsigned turn =
              w == 0
                  ? 0
                  : static_cast<unsigned>(std::countr_one((w & 1U) != 0 ? w : w - 1)) % dimension;
          axis = (axis + turn + 1) % dimension;
        }
        entry[std::size_t{state} * kCells + cell] =
            static_cast<std::uint16_t>((axis * kCorners + entry_corner) * kCells + place);
      }
    }
  }
};

template <unsigned dimension, unsigned levels>
inline constexpr Table<dimension, levels> kTable{};

}  // namespace hilbert_detail

/// The place of a cell along the Hilbert curve of a grid of 2^bits cells a side.
/// Requires coordinates below 2^bits, dimension × bits ≤ 64, dimension 2 or 3.
/// (1) Bijective onto 0 … 2^(dimension × bits) − 1. (2) Consecutive places are adjacent cells.
template <unsigned dimension>
[[nodiscard]] constexpr std::uint64_t hilbert_index(
    const std::array<std::uint32_t, dimension>& cell, unsigned bits) {
  constexpr unsigned levels = dimension == 2 ? 4 : 2;
  const auto& table = hilbert_detail::kTable<dimension, levels>;
  // Cells of a larger grid, near its first corner: the curve comes there first, and its part
  // in that corner is one of the smaller grid.
  const unsigned padded = (bits + levels - 1) / levels * levels;
  std::uint32_t state = 0;
  std::uint64_t index = 0;
  for (unsigned shift = padded; shift != 0;) {
    shift -= levels;
    std::uint32_t digit = 0;
    for (const std::uint32_t coordinate : cell) {
      digit = (digit << levels) | ((coordinate >> shift) & ((1U << levels) - 1));
    }
    const std::uint32_t found = table.entry[std::size_t{state} * table.kCells + digit];
    state = found / table.kCells;
    index = (index << (dimension * levels)) | (found % table.kCells);
  }
  return index;
}

}  // namespace tetloft::internal
