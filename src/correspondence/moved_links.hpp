// Candidates of criterion `moved`: rule 1 of include/tetloft/correspondence.hpp.
#pragma once

#include <vector>

#include "correspondence/candidate.hpp"
#include "correspondence/overlap_links.hpp"
#include "correspondence/section_regions.hpp"
#include "motion/region_motions.hpp"

namespace tetloft::internal {

/// The motions of a slab's regions that have no clear partner; of others none.
[[nodiscard]] SlabMotions motions_where_unclear(SlabId slab, const SectionStack& stack,
                                                const IdVector<SectionId, Nesting>& nestings,
                                                const SectionRegions& below,
                                                const SectionRegions& above,
                                                const std::vector<OverlappingPair>& overlapping);

/// All pairs that overlap as they lie or, within reach, as they are moved: those that the rule
/// takes, and the others.
[[nodiscard]] SlabCandidates moved_links(SlabId slab, const SectionRegions& below,
                                         const SectionRegions& above,
                                         const std::vector<OverlappingPair>& overlapping,
                                         const SlabMotions& motions, double tau);

}  // namespace tetloft::internal
