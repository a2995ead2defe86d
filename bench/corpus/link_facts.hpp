// What rules of correspondence look at: overlaps, distances and motions of the regions of a stack.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/sections.hpp>

namespace tetloft::bench {

/// No rule but Definition 2 links regions farther from each other, in gaps.
inline constexpr double kReach = 1;

/// Two regions of a slab within kReach.
struct PairFacts {
  std::size_t low = 0, high = 0;
  double plain = 0;     ///< overlap_ratio as they lie
  double distance = 0;  ///< in gaps; 0 if they overlap
  /// overlap_ratio with the lower region moved by its motion, with the upper one moved back by
  /// its own, and with the lower one moved by the mean of both motions.
  double moved_low = 0, moved_high = 0, moved_both = 0;
};

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

struct SlabFacts {
  double gap = 1;
  std::vector<double> low_area, high_area;  ///< by region
  std::size_t moving = 0;                   ///< regions whose motion is wanted
  std::vector<PairFacts> pairs;             ///< by (low, high)
  Pairs reverse;                            ///< joined by reverse tets
};

/// `rest`: the least ratio of overlaps of regions at rest (src/motion/README.md); above 1 every
/// region moves. Requires a valid stack.
[[nodiscard]] std::vector<SlabFacts> facts_of(const SectionStack& stack, double rest);

}  // namespace tetloft::bench
