// What was measured of distributions, as one picture.
#pragma once

#include <string>

#include "report.hpp"

namespace tetloft::bench {

/// An SVG file of its own: for each distribution a row with time and memory by size, and the
/// speed-up on several threads at the largest size, an engine in one colour throughout. Without
/// cases by distribution it says so.
[[nodiscard]] std::string plot_of(const Report& report);

}  // namespace tetloft::bench
