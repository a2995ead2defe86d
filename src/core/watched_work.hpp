// Work that its caller watches and may stop.
#pragma once

#include <cstddef>
#include <mutex>

#include <tetloft/execution.hpp>

namespace tetloft::internal {

/// The two ways in which an Execution lets a caller watch: its stop token, and its callback, which
/// is told the steps done and the steps in all. May be used from several threads at once; the
/// Execution must outlive it.
class WatchedWork {
 public:
  WatchedWork(const Execution& execution, std::size_t all_steps)
      : execution_(execution), all_(all_steps) {}

  [[nodiscard]] const Execution& execution() const { return execution_; }
  /// Throws Cancelled once a stop was requested.
  void go_on() const;
  /// Tells the callback, one call at a time; throws Cancelled where that throws.
  void step_done();
  /// Both.
  void step_done_go_on() {
    step_done();
    go_on();
  }

 private:
  const Execution& execution_;
  std::size_t all_;
  std::mutex mutex_;  // of done_, and of calls
  std::size_t done_ = 0;
};

/// For a part of the work: threads and stop token of the whole, which alone tells its steps.
[[nodiscard]] inline Execution untold(const Execution& whole) {
  return {.threads = whole.threads, .stop = whole.stop};
}

}  // namespace tetloft::internal
