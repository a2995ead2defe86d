// Which stage of a predicate answered; counted only while a PredicateCounting scope lives.
//
// The pointer is thread-local and null outside such a scope: it redirects statistics and
// never influences an answer, hence is no mutable global in the sense of the house.
#pragma once

#include <cstdint>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::predicates {

using Stages = PredicateCounters::Stages;
using Stage = std::uint64_t Stages::*;
using Predicate = Stages PredicateCounters::*;

extern constinit thread_local PredicateCounters* counters;

/// Adds one call of `predicate` answered by `stage`.
inline void count_answer(Predicate predicate, Stage stage) {
  if (counters != nullptr) [[unlikely]] {
    ++((counters->*predicate).*stage);
  }
}

}  // namespace tetloft::internal::predicates
