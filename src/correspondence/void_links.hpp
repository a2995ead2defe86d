// Candidates among voids: rules V1 and V3 of include/tetloft/voids.hpp. Voids are the regions of
// sections' complements (sections/complement.hpp). V2: chain_links.hpp.
#pragma once

#include <tetloft/correspondence.hpp>

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"
#include "sections/face_overlay.hpp"

namespace tetloft::internal {

/// r of two voids, of which one is a hole at least, whatever lies far away from it.
[[nodiscard]] double void_ratio(const SectionRegions& below, RegionId lower,
                                const SectionRegions& above, RegionId upper);

/// What V0 asks of the regions of a slab.
struct RegionsAround {
  const std::vector<Link>& links;  ///< accepted ones, sorted
  /// The region around a void; invalid for the exterior.
  IdVector<RegionId, RegionId> below, above;
};

/// All pairs of voids that overlap but the two exteriors: those that V1 takes, and the others;
/// those of V0 are outruled. overlay: of the two sections that below and above are the complements
/// of.
[[nodiscard]] SlabCandidates overlapping_voids(SlabId slab, const SectionRegions& below,
                                               const SectionRegions& above,
                                               const sections::FaceOverlay& overlay,
                                               const RegionsAround& regions);

/// What V3 gives the holes without a candidate among these, of V1 and V2: made, or, where nothing
/// is within its reach, not; none that is outruled there. A pair may be there twice.
[[nodiscard]] SlabCandidates rim_links(SlabId slab, const SectionRegions& below,
                                       const SectionRegions& above,
                                       const SlabCandidates& candidates, const VoidOptions& rule);

}  // namespace tetloft::internal
