// A slab that has sections between its two as layers, and what belongs together from each to the
// next.
#pragma once

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

/// From below: the slab's lower section, those between, its upper one.
using Layers = std::vector<NestedSection>;
[[nodiscard]] Layers layers_of(const NestedSection& lower, const NestedSection& upper,
                               const between::InnerSections& inner);

/// The links of regions between the layers, by slab; sorted, as they are.
[[nodiscard]] IdVector<SlabId, std::vector<Link>> layer_region_links(
    const between::InnerSections& inner);

}  // namespace tetloft::internal
