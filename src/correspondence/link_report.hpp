// Candidates as their user sees them.
#pragma once

#include <vector>

#include <tetloft/nesting.hpp>

#include "correspondence/candidate.hpp"

namespace tetloft::internal {

/// All of a stack, by (slab, lower, upper region), with leads where there are rivals.
[[nodiscard]] std::vector<RegionLink> region_links(const StackCandidates& candidates,
                                                   const IdVector<SectionId, Nesting>& nestings);

}  // namespace tetloft::internal
