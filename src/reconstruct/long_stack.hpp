// The longer stack: a built one with the sections between that slabs took, and its links.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/between.hpp>

#include "reconstruct/phases.hpp"

namespace tetloft::internal {

/// In the unit of the built stack.
struct LongLayers {
  PreparedStack prepared;  ///< stack and nestings alone: nothing is conforming
  IdVector<SectionId, SectionSource> source;
  IdVector<SectionId, IdVector<ContourId, ComponentId>> component;
  /// Of regions, in each slab of the longer stack; sorted.
  IdVector<SlabId, std::vector<Link>> regions;
  /// Of voids, where something was decided about them; those of exteriors, which are certain, may
  /// be there or not.
  std::optional<IdVector<SlabId, std::vector<Link>>> voids;
};

/// Requires the parts of the stack.
[[nodiscard]] LongLayers long_layers(const BuiltStack& built);

/// What says exactly these links: LongStack::correspondence.
[[nodiscard]] Result<CorrespondenceOptions> settled(const LongLayers& layers,
                                                    const Execution& execution);

}  // namespace tetloft::internal
