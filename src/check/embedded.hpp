#pragma once

#include "check/findings.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// Guarantee 3, conditions 3.1 to 3.4 of README.md: the tets overlap nowhere and the
/// boundary surface touches itself nowhere, in stored coordinates.
[[nodiscard]] Findings check_embedded(const ModelView& view, const SurfaceComponents& surface,
                                      const CheckOptions& options);

}  // namespace tetloft::internal::checking
