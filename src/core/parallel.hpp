// Parallel loops over independent indices on standard threads.
#pragma once

#include <cstddef>
#include <functional>

#include <tetloft/execution.hpp>

#include "core/guard.hpp"

namespace tetloft::internal {

/// The number of threads `requested` stands for: at most kMostThreads, and for 0 what
/// the machine offers.
[[nodiscard]] unsigned thread_count(unsigned requested);

/// Calls body(i) once for every i in 0 … n−1 on up to `threads` threads (0: as many as the
/// machine offers) and waits. Iterations must not depend on each other; they start in
/// increasing order. Of exceptions thrown by iterations the one of the lowest index is
/// rethrown, after all started iterations ended. Where the system refuses a thread the others do
/// its work: the calling thread is one of them. Their CPU time counts as the caller's
/// (cpu_clock.hpp).
void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& body);

/// Runs an API function's body(execution) as guard_internal does. Where memory ends while several
/// threads work, whose stacks and pools take some of it, the calling thread does the work once
/// more alone, and tells no progress.
template <class Body>
auto guard_threads(const Execution& execution, Body&& body) -> decltype(body(execution)) {
  auto result = guard_internal([&] { return body(execution); });
  if (result || result.error().code != ErrorCode::out_of_memory ||
      thread_count(execution.threads) == 1) {
    return result;
  }
  return guard_internal([&] { return body(Execution{.threads = 1, .stop = execution.stop}); });
}

/// The same for a function whose options hold its Execution.
template <class Options, class Body>
auto guard_threads(const Options& options, Body&& body) -> decltype(body(options)) {
  return guard_threads(options.execution, [&](const Execution& execution) {
    if (&execution == &options.execution) return body(options);
    Options other = options;
    other.execution = execution;
    return body(other);
  });
}

}  // namespace tetloft::internal
