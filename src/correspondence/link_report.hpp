// Candidates as their user sees them.
#pragma once

#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/voids.hpp>

#include "correspondence/candidate.hpp"

namespace tetloft::internal {

/// All of a stack, by (slab, lower, upper region), with leads where there are rivals.
[[nodiscard]] std::vector<RegionLink> region_links(const StackCandidates& candidates,
                                                   const IdVector<SectionId, Nesting>& nestings);
/// The same of voids, of complements with these nestings: the exterior's many pairs are no rivals.
[[nodiscard]] std::vector<VoidLink> void_links(const StackCandidates& candidates,
                                               const IdVector<SectionId, Nesting>& complements);

}  // namespace tetloft::internal
