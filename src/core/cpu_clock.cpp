// The one place that asks the platform for the time of a thread.
#include "core/cpu_clock.hpp"

#include <chrono>
#include <ctime>

namespace tetloft::internal {

namespace {

double thread_seconds() noexcept {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
#endif
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Each thread's own; nothing but reports of time depends on it.
thread_local double helped = 0;

}  // namespace

double work_seconds() noexcept { return thread_seconds() + helped; }

void add_helpers_seconds(double seconds) noexcept { helped += seconds; }

}  // namespace tetloft::internal
