// Point distributions of the literature at any size, engines on one thread and on several.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cases.hpp"

namespace tetloft::bench {

struct DistributionOptions {
  std::vector<std::size_t> sizes{10'000, 100'000};
  std::vector<unsigned> threads{1};  ///< ascending
  std::vector<std::string> files;    ///< of points, or surfaces of which the vertices are taken
};

/// "distribution NAME SIZE" for each distribution and size, and "distribution NAME" for each file.
[[nodiscard]] std::vector<Case> distribution_cases(const DistributionOptions& options);

}  // namespace tetloft::bench
