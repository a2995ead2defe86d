// The scope that counts which stages answered.
#include "predicates/counting.hpp"

namespace tetloft {

namespace predicates {

constinit thread_local PredicateCounters* counters = nullptr;

}  // namespace predicates

PredicateCounting::PredicateCounting(PredicateCounters& counters) : outer_(predicates::counters) {
  predicates::counters = &counters;
}

PredicateCounting::~PredicateCounting() { predicates::counters = outer_; }

}  // namespace tetloft
