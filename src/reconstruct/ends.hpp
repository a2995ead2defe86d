// Where a model ends at the first and last section.
#pragma once

#include <optional>
#include <vector>

#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// The planes of the prisms beyond the first and last section; none where it ends at these. Warns
/// where a thickness had to be chosen. Fails (unrepresentable) where no double lies beyond.
[[nodiscard]] Result<EndPlanes> place_ends(const PreparedStack& prepared,
                                           const ReconstructOptions& options,
                                           std::vector<Warning>& warnings);

}  // namespace tetloft::internal
