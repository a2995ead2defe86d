// Step 7 of the rule of include/tetloft/correspondence.hpp: links that connect what one label
// still leaves apart.
#pragma once

#include <set>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "correspondence/labelled_sets.hpp"
#include "correspondence/region_names.hpp"

namespace tetloft::internal {

/// Adds the links for all labels to `accepted`, in increasing order, none of them closed, and
/// unites their sets. Refused
/// (unrepresentable) where a label cannot be realised, naming contours.
[[nodiscard]] Result<void> connect_labels(const SectionStack& stack,
                                          const IdVector<SectionId, Nesting>& nestings,
                                          const StackRegions& regions, const RegionLabels& labels,
                                          const RegionNames& names, const std::set<Link>& closed,
                                          LabelledSets& sets, std::vector<Link>& accepted);

}  // namespace tetloft::internal
