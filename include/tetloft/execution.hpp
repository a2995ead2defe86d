// How a function that may take long is run, watched and stopped: the same for all of them.
#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>

namespace tetloft {

/// More threads than this count as so many.
inline constexpr unsigned kMostThreads = 1024;

/// Every function that may run for seconds takes one: as `execution` of its options, or last.
struct Execution {
  /// Threads that share the work; 0: as many as the machine offers. What cannot be shared runs on
  /// one. The result is the same.
  unsigned threads = 0;
  /// Once a stop is requested (from any thread), the function ends with ErrorCode::cancelled as
  /// soon as the steps in work (sections, slabs, rows of pixels, some thousand points) are done.
  std::stop_token stop = {};
  /// Called from any thread, one call at a time, with steps done and steps in all. What it throws
  /// ends the function with ErrorCode::cancelled. Where the result shows early, the last steps are
  /// not told.
  std::function<void(std::size_t done, std::size_t all)> progress = {};
};

/// Of the work limits that options have: no sane stack comes near it; what does is refused within
/// seconds.
inline constexpr double kDefaultWorkLimit = 128;

}  // namespace tetloft
