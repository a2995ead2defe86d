// Permutations of the four local vertices of a tet.
#pragma once

#include <array>
#include <cstddef>

namespace tetloft::internal::mesh_detail {

/// For local vertices i != j, the k for which (i, j, k, l) is an even permutation of
/// (0, 1, 2, 3); −1 for i = j. In a positive tet, k → l turns counter-clockwise about
/// i → j, hence the next tet about the edge lies across face k, the previous across l.
inline constexpr std::array<std::array<int, 4>, 4> kTurn{
    {{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}}};

[[nodiscard]] constexpr int turn(int i, int j) {
  return kTurn[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
}

}  // namespace tetloft::internal::mesh_detail
