// Time and memory, measured in a process of their own.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "engines.hpp"

namespace tetloft::bench {

class Clock {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Contestant {
  std::string name;
  Runner run;
};

struct Measurement {
  std::string name;
  std::vector<double> seconds;  // one for each round
  std::size_t simplices = 0;
  double peak_megabytes = 0;  // of a process that ran it once; input included
  std::string failure;        // empty unless it failed
  [[nodiscard]] double best() const;
  [[nodiscard]] double median() const;
};

/// The median over rounds of a / b.
[[nodiscard]] double median_ratio(const Measurement& a, const Measurement& b);

/// Lets the contestants run in turns, `rounds` times, in one child process, and once more each
/// in one of its own for its peak memory.
[[nodiscard]] std::vector<Measurement> measure(const std::vector<Contestant>& contestants,
                                               int rounds);

}  // namespace tetloft::bench
