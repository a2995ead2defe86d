// A progress line on standard error.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "cli/console.hpp"

namespace tetloft::cli {

/// "45 %, 12 s left", after a second of work; before, and at the end, "45 %".
[[nodiscard]] std::string progress_text(std::size_t percent, double seconds);

/// Shows that while a command works, only where standard error is a terminal and
/// `enabled`; leaves nothing behind. Its callback may be called from any thread, one call at
/// a time, while it lives.
class Progress {
 public:
  explicit Progress(bool enabled);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Empty where nothing is to be shown.
  [[nodiscard]] std::function<void(std::size_t done, std::size_t all)> callback();

 private:
  bool enabled_;
  Stopwatch watch_;
  std::size_t shown_ = kNothing;  // the percentage on the screen
  static constexpr std::size_t kNothing = static_cast<std::size_t>(-1);
};

}  // namespace tetloft::cli
