// The words of tetloft_bench's command line.
#pragma once

#include <string>
#include <vector>

#include "distributions.hpp"
#include "dynamic_cases.hpp"

namespace tetloft::bench {

struct BenchOptions {
  std::string only;
  int rounds = 5;
  double limit = 120;
  std::vector<std::string> peers{"CGAL", "TetGen", "Qhull", "HXT", "geogram", "Voro++"};
  bool list = false;
  std::vector<std::string> stacks;
  DistributionOptions distributions;
  DynamicOptions dynamic;
  std::string json;
  std::string markdown;
  std::string plot;
};

extern const char* const kBenchUsage;

/// What is wrong with the words, or nothing.
[[nodiscard]] std::string parse(int argc, char** argv, BenchOptions& options);

}  // namespace tetloft::bench
