// Voronoi cells of periodic sets, in straight boxes and in skewed ones.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cases.hpp"

namespace tetloft::bench {

/// "periodic SET BOX SIZE" for each set, box and size. Peers whose volumes are not ours fail.
[[nodiscard]] std::vector<Case> periodic_cases(std::span<const std::size_t> sizes);

}  // namespace tetloft::bench
