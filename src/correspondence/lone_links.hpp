// Candidates of lone regions: rule 3 of include/tetloft/correspondence.hpp.
#pragma once

#include <vector>

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"
#include "motion/region_motions.hpp"

namespace tetloft::internal {

/// The candidate that each lone region of a section prefers: made, or, where none is within its
/// reach, not. candidates: those of rules 1 and 2; motions: as rule 1 took them; of all slabs, of
/// which those beside the section are looked at.
[[nodiscard]] std::vector<LinkCandidate> lone_links(SectionId section,
                                                    const StackSections& sections,
                                                    const StackCandidates& candidates,
                                                    const IdVector<SlabId, SlabMotions>& motions);

}  // namespace tetloft::internal
