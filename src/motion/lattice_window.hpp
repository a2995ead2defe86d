// The lattice on which a slab is sampled, and windows of it.
//
// Its step is a quarter of the slab's gap and sample (0, 0) lies at the origin: in lattice units
// sample (i, j) lies at (i, j).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace tetloft::internal::motion {

/// Steps in a gap: a power of two, so that lattice units and gaps differ by an exact factor.
inline constexpr int kStepsPerGap = 4;

/// Samples (i, j) with i0 ≤ i < i1 and j0 ≤ j < j1.
struct LatticeWindow {
  std::int64_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
  [[nodiscard]] std::size_t nx() const { return static_cast<std::size_t>(i1 - i0); }
  [[nodiscard]] std::size_t ny() const { return static_cast<std::size_t>(j1 - j0); }
  [[nodiscard]] std::size_t size() const { return nx() * ny(); }
  /// The place of sample (i, j), row by row.
  [[nodiscard]] std::size_t place(std::int64_t i, std::int64_t j) const {
    return static_cast<std::size_t>(j - j0) * nx() + static_cast<std::size_t>(i - i0);
  }
  [[nodiscard]] LatticeWindow widened(std::int64_t margin) const {
    return {i0 - margin, j0 - margin, i1 + margin, j1 + margin};
  }
  [[nodiscard]] LatticeWindow joined(const LatticeWindow& w) const {
    return {std::min(i0, w.i0), std::min(j0, w.j0), std::max(i1, w.i1), std::max(j1, w.j1)};
  }
};

}  // namespace tetloft::internal::motion
