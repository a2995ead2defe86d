// The predicates, by the stage that answers.
#pragma once

#include <string>
#include <vector>

namespace tetloft::bench {

struct PredicateTime {
  std::string predicate;
  std::string input;       // the family of arguments, the same for all predicates
  std::string stage;       // or "all": the family as a whole
  double nanoseconds = 0;  // for one of the calls that this stage settles, earlier stages included
  double share = 0;        // of the family's calls that this stage settles
};

/// Times each predicate on the same families of arguments: each family as a whole, then the calls
/// that each stage settles, by themselves.
[[nodiscard]] std::vector<PredicateTime> time_predicates(int rounds);

}  // namespace tetloft::bench
