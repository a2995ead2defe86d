#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/cpu_clock.hpp"

namespace tetloft::internal {

namespace {

// One loop's iterations, handed out to whoever works on it.
class Loop {
 public:
  Loop(std::size_t n, const std::function<void(std::size_t)>& body) : n_(n), body_(body) {}

  void work() noexcept {
    while (!failed_.load(std::memory_order_relaxed)) {
      const std::size_t i = next_.fetch_add(1);
      if (i >= n_) return;
      try {
        body_(i);
      } catch (...) {
        const std::scoped_lock lock(mutex_);
        failed_ = true;
        if (first_ && first_index_ < i) continue;
        first_index_ = i;
        first_ = std::current_exception();
      }
    }
  }

  // On a helper thread: its time is the caller's.
  void help() noexcept {
    const WorkStopwatch watch;
    work();
    const std::scoped_lock lock(mutex_);
    helped_ += watch.seconds();
  }

  // When all work is done.
  void end() const {
    add_helpers_seconds(helped_);
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::size_t n_;
  const std::function<void(std::size_t)>& body_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr first_;  // of the lowest iteration that failed
  std::size_t first_index_ = 0;
  double helped_ = 0;
};

// Threads that help with a loop; it waits for them before it dies.
class Helpers {
 public:
  // Fewer where the system gives no more threads, or no memory for them: the caller works too.
  Helpers(std::size_t count, Loop& loop) {
    try {
      threads_.reserve(count);
      for (std::size_t k = 0; k < count; ++k) threads_.emplace_back([&loop] { loop.help(); });
    } catch (...) {
      return;
    }
  }
  ~Helpers() {
    for (std::thread& thread : threads_) thread.join();
  }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

 private:
  std::vector<std::thread> threads_;
};

}  // namespace

unsigned thread_count(unsigned requested) {
  if (requested != 0) return std::min(requested, kMostThreads);
  return std::max(1U, std::thread::hardware_concurrency());
}

void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& body) {
  // Of a single index the system need not be asked how many it has, which takes longer than some.
  const std::size_t workers = n < 2 ? n : std::min<std::size_t>(thread_count(threads), n);
  Loop loop(n, body);
  if (workers > 1) {
    const Helpers helpers(workers - 1, loop);
    loop.work();
  } else {
    loop.work();
  }
  loop.end();
}

}  // namespace tetloft::internal
