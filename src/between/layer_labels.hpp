// Connected parts of a class in one layer, and of what is not the class, by samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

inline constexpr std::uint32_t kNoNode = 0xFFFFFFFFU;
/// The void around everything is the first one of each layer.
inline constexpr std::uint32_t kExterior = 0;

/// Samples of one node side by side in a row: places first ≤ place < end.
struct LabelledRun {
  std::uint32_t first, end, node;
};

/// The nodes that a layer adds to a graph of layers.
struct LayerLabels {
  std::vector<LabelledRun> runs;  ///< ascending; the samples of no node are in none
  std::vector<std::size_t> size;  ///< samples, by node; of the exterior the most there can be
  /// Of solids: how many voids they enclose.
  std::size_t enclosed = 0;

  /// Of the sample at this place, or kNoNode; by bisection.
  [[nodiscard]] std::uint32_t node_at(std::uint32_t place) const;
  /// By place, of so many, or kNoNode.
  [[nodiscard]] std::vector<std::uint32_t> nodes(std::size_t places) const;
};

inline constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();

/// The 4-connected parts of the inside samples, numbered by their first samples, row by row.
/// Requires that the window's border is outside.
[[nodiscard]] LayerLabels label_solids(const motion::LatticeWindow& window,
                                       const std::vector<double>& value);
/// The 8-connected parts of the outside samples; requires the same.
[[nodiscard]] LayerLabels label_voids(const motion::LatticeWindow& window,
                                      const std::vector<double>& value);

/// Looks up nodes in runs: quickly where places are near each other.
class RunCursor {
 public:
  /// `runs` must outlive this.
  RunCursor(const std::vector<LabelledRun>& runs, const motion::LatticeWindow& window);

  /// The node of a place in row `row` of the window, or kNoNode.
  [[nodiscard]] std::uint32_t node_at(std::size_t row, std::size_t place) {
    if (place < first_ || place >= end_) move_to(row, place);
    return node_;
  }
  /// The runs of a row of the window.
  [[nodiscard]] std::span<const LabelledRun> in_row(std::size_t row) const {
    return {runs_.data() + in_row_[row], runs_.data() + in_row_[row + 1]};
  }

 private:
  void move_to(std::size_t row, std::size_t place);

  const std::vector<LabelledRun>& runs_;
  std::size_t nx_;
  std::vector<std::size_t> in_row_;  // the first run, by row, and behind the last row
  // The run, or the gap between two, that was looked at last.
  std::size_t first_ = 0, end_ = 0;
  std::uint32_t node_ = kNoNode;
};

/// Of nodes by place; sizes are left to the caller.
[[nodiscard]] std::vector<LabelledRun> runs_of(const motion::LatticeWindow& window,
                                               const std::vector<std::uint32_t>& node);

/// The samples of each node but the exterior, row by row.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> samples_by_node(const LayerLabels& labels);

}  // namespace tetloft::internal::between
