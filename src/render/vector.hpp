// Vectors of space, for drawing.
#pragma once

#include "core/vector.hpp"

namespace tetloft::internal::render {

using namespace vectors;

}  // namespace tetloft::internal::render
