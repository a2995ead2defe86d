// What belongs together in a slab that has sections between its two, from layer to layer.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "between/inner_sections.hpp"
#include "slab/link.hpp"

namespace tetloft::internal {

/// A section and how it is nested.
struct NestedSection {
  const Section& section;
  const Nesting& nesting;
};

/// The accepted links of voids (sections/complement.hpp numbers them) in each slab between layers,
/// of which the first is `lower`, the last `upper`: by the rule of voids.hpp, of these layers alone
/// and whatever the user asks for. `of_regions`: the links of regions between the layers, sorted.
/// Nothing where the rule has no answer.
[[nodiscard]] std::optional<IdVector<SlabId, std::vector<Link>>> layer_void_links(
    const NestedSection& lower, const NestedSection& upper, const between::InnerSections& inner,
    const IdVector<SlabId, std::vector<Link>>& of_regions);

/// The links of regions between the layers, by slab; sorted, as they are.
[[nodiscard]] IdVector<SlabId, std::vector<Link>> layer_region_links(
    const between::InnerSections& inner);

}  // namespace tetloft::internal
