// Handles that no link implies are filled: tunnels through the solid of a class that completion
// left open though its void needs them not.
#pragma once

#include <cstdint>
#include <vector>

#include "completion/completion.hpp"
#include "completion/slab_voids.hpp"

namespace tetloft::internal {

/// Classes whose Euler characteristics count as one, and what their sum should be.
struct ChiRange {
  std::vector<ClassId> classes;
  std::int32_t least = 0, most = 0;
};

/// Keeps tets, the smallest first, each of which brings a group's Euler characteristic, where it is
/// below what it should be, nearer, and parts no void from another that it hung together with.
/// Returns how many handles went.
std::uint64_t fill_handles(const Slab& slab, const SlabClasses& classes,
                           const IdVector<ClassId, std::uint8_t>& active, const SlabVoids& voids,
                           const std::vector<ChiRange>& groups, Completion& completion);

}  // namespace tetloft::internal
