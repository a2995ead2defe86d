// Windows of the square lattice on which a slab is sampled.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tetloft::internal {

/// Samples (i, j) with i0 ≤ i < i1 and j0 ≤ j < j1; sample (i, j) lies at (i, j) in units of the
/// lattice's step.
struct LatticeWindow {
  std::int64_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
  [[nodiscard]] std::size_t nx() const { return static_cast<std::size_t>(i1 - i0); }
  [[nodiscard]] std::size_t ny() const { return static_cast<std::size_t>(j1 - j0); }
  [[nodiscard]] std::size_t size() const { return nx() * ny(); }
  [[nodiscard]] LatticeWindow widened(std::int64_t margin) const {
    return {i0 - margin, j0 - margin, i1 + margin, j1 + margin};
  }
  [[nodiscard]] LatticeWindow joined(const LatticeWindow& w) const {
    return {std::min(i0, w.i0), std::min(j0, w.j0), std::max(i1, w.i1), std::max(j1, w.j1)};
  }
};

}  // namespace tetloft::internal
