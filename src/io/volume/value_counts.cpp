// Counting values of voxels.
#include "io/volume/value_counts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace tetloft::internal::io {

namespace {

class ValueCounter {
 public:
  // Small integers are counted by index where there are more voxels than indices.
  explicit ValueCounter(std::size_t voxels) {
    if (voxels > kIndices) indexed_.resize(kIndices);
  }

  void count(double value) {
    if (std::isnan(value)) {
      ++counts_.not_numbers;
      return;
    }
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
    if (counts_.too_many) return;
    std::size_t& counted = counter_of(value);
    if (counted++ == 0 && ++different_ > kMostLabels) counts_.too_many = true;
  }

  ValueCounts finished() && {
    if (least_ <= largest_) {
      counts_.least = least_;
      counts_.largest = largest_;
    }
    if (counts_.too_many) return std::move(counts_);
    for (std::size_t i = 0; i < indexed_.size(); ++i) {
      if (indexed_[i] > 0) others_[static_cast<double>(i) + kLeastIndexed] = indexed_[i];
    }
    counts_.values.assign(others_.begin(), others_.end());
    return std::move(counts_);
  }

 private:
  static constexpr double kLeastIndexed = -32768;
  static constexpr double kLastIndexed = 65535;
  static constexpr auto kIndices = static_cast<std::size_t>(kLastIndexed - kLeastIndexed) + 1;

  std::size_t& counter_of(double value) {
    const bool integer = std::isfinite(value) && value == std::trunc(value);
    if (integer && !indexed_.empty() && value >= kLeastIndexed && value <= kLastIndexed) {
      return indexed_[static_cast<std::size_t>(value - kLeastIndexed)];
    }
    if (!integer) counts_.all_integers = false;
    return others_[value];
  }

  ValueCounts counts_;
  std::vector<std::size_t> indexed_;  ///< from kLeastIndexed on; or empty
  std::map<double, std::size_t> others_;
  std::size_t different_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::size_t ValueCounts::of(double value) const {
  const auto at = std::lower_bound(
      values.begin(), values.end(), value,
      [](const std::pair<double, std::size_t>& counted, double v) { return counted.first < v; });
  return at != values.end() && at->first == value ? at->second : 0;
}

Result<ValueCounts> count_values(Volume& volume, std::size_t layer, WatchedWork& work) {
  const VolumeHeader& header = volume.header();
  const std::size_t slice = header.size[0] * header.size[1];
  ValueCounter counter(header.voxels());
  std::size_t voxels = 0;
  const Result<void> read =
      volume.for_each_piece(layer, [&](std::span<const double> values) -> Result<void> {
        work.go_on();
        for (const double value : values) counter.count(value);
        const std::size_t before = voxels / slice;
        voxels += values.size();
        for (std::size_t i = before; i < voxels / slice; ++i) work.step_done();
        return {};
      });
  if (!read) return read.error();
  return std::move(counter).finished();
}

}  // namespace tetloft::internal::io
