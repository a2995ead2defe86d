// Candidates that continue a chain: rule 2 of include/tetloft/correspondence.hpp, and V2 of
// include/tetloft/voids.hpp.
#pragma once

#include <tetloft/voids.hpp>

#include "correspondence/candidate.hpp"
#include "correspondence/section_regions.hpp"

namespace tetloft::internal {

/// What chains are made of. Of voids, exteriors count as linked, and are no origin.
struct ChainRule {
  double reach;
  bool voids;
};
inline constexpr ChainRule kRegionChains{kChainReach, false};
inline constexpr ChainRule kVoidChains{kVoidChainReach, true};

/// The further candidates of one slab, sorted, and pairs that nearly were. by_criterion: those of
/// rule 1 or V1, of all slabs; only this slab's and those of the slabs beside it are looked at.
[[nodiscard]] SlabCandidates chain_links(SlabId slab, const StackSections& sections,
                                         const StackCandidates& by_criterion,
                                         const ChainRule& rule = kRegionChains);

}  // namespace tetloft::internal
