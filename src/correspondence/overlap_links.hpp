// Candidates of criterion `overlap`: rule 1 of include/tetloft/correspondence.hpp.
#pragma once

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"

namespace tetloft::internal {

/// A pair of regions whose interiors meet, with r.
struct OverlappingPair {
  RegionId lower, upper;
  double ratio = 0;
};
/// All of two sections, sorted.
[[nodiscard]] std::vector<OverlappingPair> overlapping_pairs(const SectionRegions& below,
                                                             const SectionRegions& above);

/// compare_overlap() of two with this overlap_ratio(), which nearly always tells.
[[nodiscard]] Sign compare_overlap(const RegionOutline& a, const RegionOutline& b, double tau,
                                   double ratio);

/// All pairs that overlap: those that the rule takes, and the others.
[[nodiscard]] SlabCandidates overlap_links(SlabId slab, const SectionRegions& below,
                                           const SectionRegions& above, double tau);

}  // namespace tetloft::internal
