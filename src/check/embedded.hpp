#pragma once

#include <cstddef>
#include <string>

#include "check/findings.hpp"
#include "check/view.hpp"

namespace tetloft::internal::checking {

/// Guarantee 3, conditions 3.1 to 3.4 of README.md: the tets overlap nowhere and the
/// boundary surface touches itself nowhere, in stored coordinates.
[[nodiscard]] Findings check_embedded(const ModelView& view, const SurfaceComponents& surface,
                                      const CheckOptions& options);

/// 3.1 to 3.3 of a whole, or of a segment: of triangles in its seams nothing is asked.
[[nodiscard]] Findings check_tets_and_contacts(const ModelView& view, const CheckOptions& options);

/// 3.3 at a seam: of triangles of which one lies in it, or that are of tets on its two sides. Tets
/// from this one on are of the upper side.
[[nodiscard]] Findings check_contacts_at_seam(const ModelView& view, std::size_t first_upper,
                                              const CheckOptions& options);

/// That tets lie on the outer side of the boundary surface with this triangle, in words: 3.4.
void fail_winding(Findings& findings, const std::string& place);

}  // namespace tetloft::internal::checking
