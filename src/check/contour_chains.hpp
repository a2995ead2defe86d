// Follows the contours along the boundary of the in-plane triangles.
#pragma once

#include "check/findings.hpp"
#include "check/in_plane.hpp"
#include "check/resampling.hpp"

namespace tetloft::internal::checking {

/// Conditions 2.2, 2.3 and 2.8 to 2.12 in these sections: finds each input vertex in the model and,
/// from each to the next, the inserted vertices between them.
[[nodiscard]] OnContours follow_contours(const ModelView& view, const SectionStack& stack,
                                         const ContourNumbers& numbers,
                                         const SectionRange& sections,
                                         const InPlaneComplex& complex, const CheckOptions& options,
                                         Findings& findings);

}  // namespace tetloft::internal::checking
