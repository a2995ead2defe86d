// Which regions form one component, decided for the whole stack before any complex is
// built: the rule of include/tetloft/correspondence.hpp.
#pragma once

#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "slab/link.hpp"

namespace tetloft::internal {

struct Correspondence {
  /// Accepted links of each slab, sorted.
  IdVector<SlabId, std::vector<Link>> links;
  /// The component of each region: component[section][region], numbered in order of their
  /// first contour by (section, contour).
  IdVector<SectionId, IdVector<RegionId, ComponentId>> component;
  ContourPartition partition;
};

/// Decides the correspondence from the candidates of each slab and the labels. Refused:
/// invalid_input for labels that name no contour or disagree within a region;
/// unrepresentable for labels that cannot be realised, naming contours.
[[nodiscard]] Result<Correspondence> decide_correspondence(
    const SectionStack& stack, const IdVector<SectionId, Nesting>& nestings,
    const IdVector<SlabId, std::vector<Link>>& candidates, const std::vector<Label>& labels);

}  // namespace tetloft::internal
