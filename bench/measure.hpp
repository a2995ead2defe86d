// Time and memory, each run measured in a process of its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/predicates.hpp>

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
  bool counted = false;    // whether it calls our predicates, all from one thread
  std::string left_out{};  // why it does not run; empty: it does
  std::string engine{};    // of plots: whose curve it is on; empty: of none
  unsigned threads = 1;
};

struct Measurement {
  std::string name;
  std::string engine;  // as that of the contestant
  unsigned threads = 1;
  std::vector<double> seconds;  // one for each round
  std::size_t simplices = 0;
  std::vector<std::pair<std::string, double>> steps;  // of the best round
  double peak_megabytes = 0;                  // of a process that ran it once; input included
  std::string left_out;                       // why it did not run; empty if it did
  std::string failure;                        // how it failed; empty unless it did
  std::optional<PredicateCounters> counters;  // of a run of its own, untimed
  [[nodiscard]] bool valid() const { return !seconds.empty() && failure.empty(); }
  [[nodiscard]] double best() const;
  [[nodiscard]] double median() const;
};

/// The median over rounds of a / b.
[[nodiscard]] double median_ratio(const Measurement& a, const Measurement& b);

/// Lets the contestants run in turns, `rounds` times, each run in a child process of its own,
/// killed after `limit` seconds. Who has failed once does not run again.
[[nodiscard]] std::vector<Measurement> measure(const std::vector<Contestant>& contestants,
                                               int rounds, double limit);

}  // namespace tetloft::bench
