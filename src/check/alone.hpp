// What can be checked of a model without the stack that it was made of.
#pragma once

#include <vector>

#include <tetloft/check.hpp>
#include <tetloft/tet_mesh.hpp>

#include "check/view.hpp"

namespace tetloft::internal::checking {

/// Guarantees 1 and 3, which know no contours; 2, 4 and 5 are not asked, and do not pass.
/// `surface` is of view.boundary.
[[nodiscard]] std::vector<GuaranteeVerdict> check_alone(const ModelView& view,
                                                        const SurfaceComponents& surface,
                                                        const CheckOptions& options);

}  // namespace tetloft::internal::checking
