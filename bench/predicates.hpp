// The predicates, by the stage that answers.
#pragma once

#include <string>
#include <vector>

namespace tetloft::bench {

struct PredicateTime {
  std::string predicate;
  std::string stage;
  double nanoseconds = 0;  // for one call
  double share = 0;        // of the calls that this stage answered
};

/// Times each predicate on a family of arguments for each stage. The stage told is the one that
/// answered most of them.
[[nodiscard]] std::vector<PredicateTime> time_predicates(int rounds);

}  // namespace tetloft::bench
