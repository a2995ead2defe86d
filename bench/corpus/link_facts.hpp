// What rules of correspondence look at: overlaps, distances and motions of the regions of a stack.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/sections.hpp>

namespace tetloft::bench {

/// Two regions of a slab, near each other.
struct PairFacts {
  std::size_t low = 0, high = 0;
  double plain = 0;     ///< overlap_ratio as they lie
  double distance = 0;  ///< in gaps; 0 if they overlap
  /// overlap_ratio with the lower region moved by its motion, with the upper one moved back by
  /// its own, and with each moved by half.
  double moved_low = 0, moved_high = 0, moved_joint = 0, moved_q = 0, moved_r = 0;
};

struct SlabFacts {
  double gap = 1;
  std::size_t regions = 0, moving = 0;
  std::vector<double> low_area, high_area;
  std::vector<PairFacts> pairs;  ///< those nearer than kReach gaps, by (low, high)
};

/// No rule links regions farther from each other, in gaps.
inline constexpr double kReach = 1;

[[nodiscard]] std::vector<SlabFacts> facts_of(const SectionStack& stack, double rest);

}  // namespace tetloft::bench
