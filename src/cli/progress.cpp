// Terminals are asked for by POSIX.
#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace tetloft::cli {

Progress::Progress(bool enabled) : enabled_(enabled && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_ == kNothing) return;
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

std::function<void(std::size_t, std::size_t)> Progress::callback() {
  if (!enabled_) return {};
  return [this](std::size_t done, std::size_t all) {
    const std::size_t percent = all == 0 ? 100 : done * 100 / all;
    if (percent == shown_) return;
    shown_ = percent;
    std::fprintf(stderr, "\r%3zu %%", percent);
    std::fflush(stderr);
  };
}

}  // namespace tetloft::cli
