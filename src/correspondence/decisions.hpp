// The user's decisions on single links: rule 4 of include/tetloft/correspondence.hpp, and V4 of
// include/tetloft/voids.hpp.
#pragma once

#include <set>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"

namespace tetloft::internal {

/// Makes joined pairs candidates, and parted ones none. The parted pairs; or invalid_input where a
/// decision names no contour, or two contradict each other. `voids`: sections are complements.
[[nodiscard]] Result<std::set<Link>> apply_decisions(const IdVector<SectionId, Nesting>& nestings,
                                                     const StackSections& sections,
                                                     const std::vector<LinkDecision>& decisions,
                                                     StackCandidates& candidates, bool voids);

/// A candidate that is one whatever is measured. `voids`: as above, one of them a hole.
[[nodiscard]] LinkCandidate asked_for(const Link& link, const StackSections& sections,
                                      Evidence evidence, bool voids = false);

}  // namespace tetloft::internal
