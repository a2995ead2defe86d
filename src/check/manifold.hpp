#pragma once

#include "check/findings.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// Guarantee 1, conditions 1.1 to 1.5 of README.md: the tets are a 3-manifold with boundary.
[[nodiscard]] Findings check_manifold(const ModelView& view, const CheckOptions& options);

}  // namespace tetloft::internal::checking
