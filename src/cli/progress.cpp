// Terminals are asked for by POSIX.
#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace tetloft::cli {

std::string progress_text(std::size_t percent, double seconds) {
  std::string text = std::to_string(percent);
  text.insert(0, text.size() < 3 ? 3 - text.size() : 0, ' ');
  text += " %";
  if (percent == 0 || percent >= 100 || seconds < 1) return text;
  const double done = static_cast<double>(percent) / 100;
  const double left = seconds * (1 - done) / done;
  return text + ", " + std::to_string(static_cast<long long>(left) + 1) + " s left";
}

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
    std::fprintf(stderr, "\r%s\x1b[K", progress_text(percent, watch_.seconds()).c_str());
    std::fflush(stderr);
  };
}

}  // namespace tetloft::cli
