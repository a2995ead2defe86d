// Phase 1, decide: the sections put between the two given ones of a slab, from the stack and its
// links.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "between/inner_sections.hpp"
#include "slab/link.hpp"

namespace tetloft::internal {

/// A stack and which of its regions belong together.
struct LinkedStack {
  const SectionStack& stack;  ///< valid
  const IdVector<SectionId, Nesting>& nestings;
  /// Accepted links of each slab.
  const IdVector<SlabId, std::vector<Link>>& links;
};

/// The sections between those of the slab, `count` or, without a number, as many as contour edges
/// go into the gap, about, and none where sections are dense or the same; none where none can be
/// put without changing what hangs together. A function of the four sections around the slab and of
/// the links between them: it depends neither on the order of contours nor on where they start.
[[nodiscard]] between::InnerSections sections_between(const LinkedStack& stacked, SlabId slab,
                                                      std::optional<std::size_t> count);

}  // namespace tetloft::internal
