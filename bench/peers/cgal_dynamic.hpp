// CGAL's triangulation of space as one that changes.
#pragma once

#include <vector>

#include "dynamic.hpp"

namespace tetloft::bench {

/// As it is, and with its hierarchy for searches.
[[nodiscard]] std::vector<DynamicEngine> cgal_dynamic();

}  // namespace tetloft::bench
