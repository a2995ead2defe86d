// The values of voxels, counted: labels, as long as they are few.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/inspect.hpp>

#include "core/watched_work.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

struct ValueCounts {
  /// Each value and how many voxels have it, by value; empty if too_many. Values that are no
  /// numbers are left out.
  std::vector<std::pair<double, std::size_t>> values;
  bool too_many = false;  ///< more than kMostLabels
  bool all_integers = true;
  std::size_t not_numbers = 0;
  double least = 0;  ///< of all that are numbers; 0 if none is
  double largest = 0;

  [[nodiscard]] std::size_t of(double value) const;
  /// Whether they stand for labels.
  [[nodiscard]] bool are_labels() const { return !too_many && all_integers; }
};

/// Of a layer. `work` is told each slice across the slowest axis.
[[nodiscard]] Result<ValueCounts> count_values(Volume& volume, std::size_t layer,
                                               WatchedWork& work);

}  // namespace tetloft::internal::io
