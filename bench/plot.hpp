// What was measured of distributions, as one picture.
#pragma once

#include <string>

#include "report.hpp"

namespace tetloft::bench {

/// An SVG file of its own: for each distribution a row with time and memory on one thread by size,
/// and the speed-up over one thread at the largest size, an engine in one colour throughout. Who
/// did not run on one thread is not shown. Without cases by distribution it says so.
[[nodiscard]] std::string plot_of(const Report& report);

}  // namespace tetloft::bench
