// What became of the voids, as the model tells of it: links made, forced and unrealisable, and slabs
// of another topology.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/voids.hpp>

#include "reconstruct/decide_voids.hpp"
#include "reconstruct/glue.hpp"

namespace tetloft::internal {

struct VoidOutcome {
  std::vector<VoidLink> links;
  std::vector<Deviation> deviations;
};

/// From the decision, which learns what was unrealisable, and from the solids of slabs. Nothing
/// where nothing was decided.
[[nodiscard]] VoidOutcome void_outcome(const PreparedStack& prepared,
                                       std::optional<Correspondence>& decided,
                                       const VoidDecision& decision,
                                       const std::vector<Part>& parts);

}  // namespace tetloft::internal
