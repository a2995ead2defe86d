// Doubles as floats, in order.
#pragma once

#include <algorithm>
#include <limits>

namespace tetloft::internal::contact_detail {

/// Rounded; monotone. Numbers beyond the range of float are as good as its ends.
[[nodiscard]] inline float narrowed(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

}  // namespace tetloft::internal::contact_detail
