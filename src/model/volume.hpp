// The volume of a model, on several threads.
#pragma once

#include <tetloft/model.hpp>

namespace tetloft::internal {

/// tetloft::volume(), the same at any number of threads (0: as many as the machine offers).
[[nodiscard]] double volume_of(const Model& model, unsigned threads);

}  // namespace tetloft::internal
