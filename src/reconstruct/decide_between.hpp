// Phase 1, decide: sections put between the given ones, by slab.
#pragma once

#include <optional>
#include <vector>

#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// Makes the plan's sections between anew in these slabs, by its links. In a window they are those
/// of the whole: they depend on the four sections around the slab and the links between them.
[[nodiscard]] std::optional<Error> decide_between(const PreparedStack& prepared,
                                                  const ReconstructOptions& options,
                                                  const std::vector<SlabId>& slabs,
                                                  const WatchedWork& work, Plan& plan);

}  // namespace tetloft::internal
