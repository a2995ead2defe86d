// A model times a power of two.
#pragma once

#include <tetloft/model.hpp>

namespace tetloft::internal {

/// Multiplies all coordinates and motions by 2^exponent. False, and nothing changed, where one
/// would lose a bit or is too large.
[[nodiscard]] bool scale_exactly(Model& model, int exponent);

}  // namespace tetloft::internal
