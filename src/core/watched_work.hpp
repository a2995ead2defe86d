// Work that its caller watches and may stop.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <stop_token>

namespace tetloft {

/// The two ways in which options let a caller watch: a stop token, and a callback that is told
/// the steps done and the steps in all. May be used from several threads at once; both members
/// of the options must outlive it.
class WatchedWork {
 public:
  using Progress = std::function<void(std::size_t done, std::size_t all)>;

  WatchedWork(const std::stop_token& stop, const Progress& progress, std::size_t all_steps)
      : stop_(stop), progress_(progress), all_(all_steps) {}

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
  const std::stop_token& stop_;
  const Progress& progress_;
  std::size_t all_;
  std::mutex mutex_;  // of done_, and of calls
  std::size_t done_ = 0;
};

}  // namespace tetloft
