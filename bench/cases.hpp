// The table of cases.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "measure.hpp"

namespace tetloft::bench {

struct Case {
  std::string name;
  std::string what;
  /// Points in all, and who runs. Makes the input, which lives as long as the runners.
  struct Field {
    std::size_t points = 0;
    std::vector<Contestant> own;
    std::vector<Contestant> peers;
  };
  std::function<Field(const std::vector<Peer>& peers)> make;
};

/// All cases; each file of `stacks` is one more.
[[nodiscard]] std::vector<Case> all_cases(const std::vector<std::string>& stacks);

}  // namespace tetloft::bench
