// Triangulations of the plane that change: insertion one by one, removal, questions, constraints.
#pragma once

#include <vector>

#include "cases.hpp"
#include "dynamic_cases.hpp"

namespace tetloft::bench {

/// "dynamic plane JOB SET SIZE" for each job, set and size.
[[nodiscard]] std::vector<Case> plane_cases(const DynamicOptions& options);

}  // namespace tetloft::bench
