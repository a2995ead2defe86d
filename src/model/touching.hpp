// Whether components of a model meet.
#pragma once

#include <tetloft/model.hpp>

namespace tetloft::internal {

/// Whether two components have a point in common: those of other programs may. Requires a well
/// formed model; false where it tells no components.
[[nodiscard]] bool components_touch(const Model& model);

}  // namespace tetloft::internal
