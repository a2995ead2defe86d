// Triangulations that change: insertion one by one, removal, questions.
#pragma once

#include <cstddef>
#include <vector>

#include "cases.hpp"

namespace tetloft::bench {

struct DynamicOptions {
  std::vector<std::size_t> sizes{10'000, 100'000};
  std::size_t queries = 200'000;
};

/// "dynamic JOB SET SIZE" for each job, set and size.
[[nodiscard]] std::vector<Case> dynamic_cases(const DynamicOptions& options);

}  // namespace tetloft::bench
