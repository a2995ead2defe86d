// Where a model ends at the first and last section.
#pragma once

#include <vector>

#include "reconstruct/plan.hpp"
#include "reconstruct/prepare.hpp"

namespace tetloft::internal {

/// Of a stack of one section, in its unit. Warns where it had to be chosen.
[[nodiscard]] double single_thickness(const PreparedStack& prepared,
                                      const ReconstructOptions& options,
                                      std::vector<Warning>& warnings);

/// The planes of the prisms beyond the first and last section; none where it ends at these.
/// `heights`: of all sections; `thickness_of_single` counts where there is one. Fails
/// (unrepresentable) where no double lies beyond.
[[nodiscard]] Result<EndPlanes> place_ends(const std::vector<double>& heights, Ends wanted,
                                           double thickness_of_single);

}  // namespace tetloft::internal
