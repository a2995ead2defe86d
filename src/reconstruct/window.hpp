// Windows of a planned stack: slabs next to each other, with all that is decided about them, to be
// built as if there were no others. What crosses their ends is left open (README.md, "Clusters").
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/segment.hpp"
#include "reconstruct/phases.hpp"
#include "reconstruct/section_plan.hpp"
#include "reconstruct/settle.hpp"

namespace tetloft::internal {

/// What a window has to know of the whole.
struct StackFacts {
  std::size_t sections = 0;
  std::size_t components = 0;
  int exponent = 0;                  ///< Plan::exponent
  EndPlanes ends;                    ///< of the whole
  std::optional<double> least_long;  ///< PreparedStack::least_long
};

/// Of a planned stack.
[[nodiscard]] StackFacts facts_of(const BuiltStack& planned);

/// The plan of a section.
[[nodiscard]] SectionPlan section_plan(const BuiltStack& planned, SectionId s);

/// A window, planned; its ids count from its first section. `plans`: of its sections; below and
/// above: of the sections beyond, where there are any. Refused (invalid_input), naming the section
/// of the whole, are plans that do not fit together, and sections that are not valid.
[[nodiscard]] Result<BuiltStack> window_of(const StackFacts& facts, const SlabRange& slabs,
                                           std::vector<SectionPlan> plans,
                                           std::optional<SectionPlan> below,
                                           std::optional<SectionPlan> above);

/// The window's model and clusters, with ids of slabs and sections of the whole. The window is
/// given up but for its warnings, whose places stay as they are (in_whole()). Nothing where a
/// coordinate would lose bits in the unit given: then the whole stack has to be planned in that
/// (Unit::as_given).
[[nodiscard]] std::optional<BuiltRange> take_range(const StackFacts& facts, const SlabRange& slabs,
                                                   BuiltStack& window, unsigned threads);
/// Places of slabs and sections in a window become those in the whole.
[[nodiscard]] Place in_whole(Place place, const SlabRange& slabs);

}  // namespace tetloft::internal
