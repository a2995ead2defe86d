// Handles that no link implies are filled: tunnels through the solid of a class that completion
// left open though its void needs them not.
#pragma once

#include <cstdint>
#include <vector>

#include "completion/chi_groups.hpp"
#include "completion/completion.hpp"
#include "completion/slab_voids.hpp"

namespace tetloft::internal {

/// What decides whether a complex has the topology that links imply.
struct ComplexShape {
  ChiGroups::Sums sums;
  /// Which voids hang together: of each the lowest it does with.
  std::vector<SlabVoidId> joined;
};

/// Keeps tets, the smallest first, each of which brings the characteristics of a group that is
/// below its range nearer to it, and parts no voids that hung together. `shape`: of what is
/// complete, before and after. Returns how many handles went.
std::uint64_t fill_handles(const ChiGroups& groups, const SlabVoids& voids, Completion& completion,
                           ComplexShape& shape);

/// Which voids hang together through what a complex leaves empty: of each the lowest it does with.
[[nodiscard]] std::vector<SlabVoidId> joined_voids(const Slab& slab, const SlabClasses& classes,
                                                   const SlabVoids& voids, const Complex& complex);

}  // namespace tetloft::internal
