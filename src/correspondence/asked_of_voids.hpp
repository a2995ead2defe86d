// What a user says of voids, as said of the regions of complements (sections/complement.hpp).
#pragma once

#include <tetloft/nesting.hpp>
#include <tetloft/result.hpp>

#include "correspondence/correspondence.hpp"

namespace tetloft::internal {

/// nestings: of the sections themselves. Refused: invalid_input for labels and decisions that name
/// a contour that is no hole, and for decisions on two exteriors.
[[nodiscard]] Result<Asked> asked_of_voids(const IdVector<SectionId, Nesting>& nestings,
                                           const VoidOptions& options);

}  // namespace tetloft::internal
