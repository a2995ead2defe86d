// How each region moves through a slab, from sampled signed distances of up to four sections.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

/// Displacements of regions of one slab, from its lower plane to its upper one; none where not
/// asked for.
struct SlabMotions {
  IdVector<RegionId, std::optional<Point2>> lower, upper;
};

/// The regions of a slab's sections whose motions are asked for, each once.
struct WantedRegions {
  std::vector<RegionId> lower, upper;
};

[[nodiscard]] SlabMotions estimate_motions(SlabId slab, const SectionStack& stack,
                                           const IdVector<SectionId, Nesting>& nestings,
                                           const WantedRegions& wanted);

}  // namespace tetloft::internal
