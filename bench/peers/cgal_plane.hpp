// CGAL's triangulation of the plane as one that changes.
#pragma once

#include <vector>

#include "dynamic.hpp"

namespace tetloft::bench {

/// With its hierarchy for searches; for constraints as it is.
[[nodiscard]] std::vector<PlaneEngine> cgal_plane();

}  // namespace tetloft::bench
