// What the links of regions and voids imply for the topology of a slab's solid: FACES of
// include/tetloft/voids.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/conforming_section.hpp>

#include "completion/slab_voids.hpp"
#include "sections/face_overlay.hpp"
#include "slab/classes.hpp"
#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

/// Euler characteristic of a plane region: 1, and 1 less for each hole.
[[nodiscard]] std::int32_t region_chi(const Nesting& nesting, RegionId r);

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

/// What the solid of a slab has in place of the topology that the links imply.
struct SlabDeviation {
  SlabRegionId region;  ///< the first of the group
  std::int32_t least = 0, most = 0;
  std::int32_t got = 0;
};

/// The groups of a slab, by their first regions.
[[nodiscard]] std::vector<TopologyGroup> expected_topology(const sections::FaceOverlay& overlay,
                                                           const ConformingSection& lower,
                                                           const ConformingSection& upper,
                                                           const SlabFaceLinks& links);

/// The groups that have another topology, from the Euler characteristic that each class has got.
[[nodiscard]] std::vector<SlabDeviation> deviations(const std::vector<TopologyGroup>& groups,
                                                    const SlabClasses& classes,
                                                    const IdVector<ClassId, std::int32_t>& chi);

}  // namespace tetloft::internal
