// CPU time of work, wherever it is done.
#pragma once

namespace tetloft::internal {

/// CPU seconds of the calling thread, and of the threads that helped it in parallel_for() so
/// far; only differences mean something. Time spent waiting does not count. Where the system has
/// no CPU clock for threads (POSIX's CLOCK_THREAD_CPUTIME_ID) it is wall-clock time, summed over
/// threads in the same way.
[[nodiscard]] double work_seconds() noexcept;

/// For parallel_for(): time that other threads spent on the calling thread's work.
void add_helpers_seconds(double seconds) noexcept;

/// Work since it was made, of the thread that made it.
class WorkStopwatch {
 public:
  [[nodiscard]] double seconds() const noexcept { return work_seconds() - start_; }
  /// The same, and starts anew.
  [[nodiscard]] double lap() noexcept {
    const double now = work_seconds();
    const double taken = now - start_;
    start_ = now;
    return taken;
  }

 private:
  double start_ = work_seconds();
};

}  // namespace tetloft::internal
