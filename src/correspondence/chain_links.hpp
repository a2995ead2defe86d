// Candidates that continue a chain: rule 2 of include/tetloft/correspondence.hpp.
#pragma once

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"

namespace tetloft::internal {

/// The further candidates of one slab, sorted, and pairs that nearly were. by_criterion: those of
/// rule 1, of all slabs; only this slab's and those of the slabs beside it are looked at.
[[nodiscard]] SlabCandidates chain_links(SlabId slab, const StackSections& sections,
                                         const StackCandidates& by_criterion);

}  // namespace tetloft::internal
