// What the links of regions and voids imply for the topology of a slab's solid: FACES of
// include/tetloft/voids.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "completion/slab_voids.hpp"
#include "sections/face_overlay.hpp"
#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

/// Solid classes of a slab whose Euler characteristics count as one, in most cases a single one.
struct TopologyGroup {
  /// Of all its classes, by id; the first names the group.
  std::vector<SlabRegionId> regions;
  /// Euler characteristic as the links imply: which touches are solid is open.
  std::int32_t least = 0, most = 0;
};

/// What was decided about a slab, and what could not be.
struct SlabFaceLinks {
  const std::vector<Link>& regions;
  const std::vector<Link>& voids;
  const std::vector<std::array<SlabVoidId, 2>>& united_voids;
};

/// The groups of a slab, by their first regions.
[[nodiscard]] std::vector<TopologyGroup> expected_topology(const sections::FaceOverlay& overlay,
                                                           const ConformingSection& lower,
                                                           const ConformingSection& upper,
                                                           const SlabFaceLinks& links);

}  // namespace tetloft::internal
