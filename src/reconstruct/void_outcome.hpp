// What became of the voids, as the model tells of it: links made, forced and unrealisable, and
// slabs of another topology.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/voids.hpp>

#include "correspondence/correspondence.hpp"
#include "reconstruct/glue.hpp"

namespace tetloft::internal {

struct VoidOutcome {
  std::vector<VoidLink> links;
  std::vector<Deviation> deviations;
};

/// From the decision, which learns what was unrealisable, and from the solids of slabs. Nothing
/// where nothing was decided.
/// `complements` are those of the decision (VoidDecision::complements()).
[[nodiscard]] VoidOutcome void_outcome(const IdVector<SectionId, ConformingSection>& sections,
                                       std::optional<Correspondence>& decided,
                                       const IdVector<SectionId, Nesting>& complements,
                                       const std::vector<Part>& parts);

}  // namespace tetloft::internal
