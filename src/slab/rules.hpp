// What the steps of a slab report: how often rules fired, and how long steps took.
#pragma once

#include <array>
#include <cstdint>

#include <tetloft/report.hpp>

#include "core/cpu_clock.hpp"

namespace tetloft::internal {

using RuleCounts = std::array<std::uint64_t, kRules>;
/// CPU seconds by step.
using StepSeconds = std::array<double, kSteps>;

inline void count(RuleCounts& rules, Rule rule, std::uint64_t times = 1) {
  rules[static_cast<std::size_t>(rule)] += times;
}

inline void add_seconds(StepSeconds& seconds, Step step, double more) {
  seconds[static_cast<std::size_t>(step)] += more;
}

/// Adds the time since the last call, or its making, to a step.
class StepClock {
 public:
  explicit StepClock(StepSeconds& seconds) : seconds_(seconds) {}
  void end(Step step) { add_seconds(seconds_, step, watch_.lap()); }

 private:
  StepSeconds& seconds_;
  WorkStopwatch watch_;
};

}  // namespace tetloft::internal
