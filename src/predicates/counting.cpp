// The scope that counts which stages answered.
#include "predicates/counting.hpp"

namespace tetloft::internal::predicates {

constinit thread_local PredicateCounters* counters = nullptr;

}  // namespace tetloft::internal::predicates

namespace tetloft {

using namespace internal;

PredicateCounting::PredicateCounting(PredicateCounters& counters) : outer_(predicates::counters) {
  predicates::counters = &counters;
}

PredicateCounting::~PredicateCounting() { predicates::counters = outer_; }

}  // namespace tetloft
