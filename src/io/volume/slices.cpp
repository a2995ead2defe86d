// Gathering slices from values that come one after the other.
#include "io/volume/slices.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/guard.hpp"

namespace tetloft::internal::io {

namespace {

/// Where the next value stands, the fastest index first.
class VoxelCounter {
 public:
  explicit VoxelCounter(const std::array<std::size_t, 3>& size) : size_(size) {}
  [[nodiscard]] std::size_t operator[](std::size_t axis) const { return at_[axis]; }
  /// Up to the end of the row.
  [[nodiscard]] std::size_t row_left() const { return size_[0] - at_[0]; }
  /// At most row_left().
  void go_on(std::size_t count) {
    at_[0] += count;
    for (std::size_t axis = 0; axis < 2 && at_[axis] == size_[axis]; ++axis) {
      at_[axis] = 0;
      ++at_[axis + 1];
    }
  }

 private:
  std::array<std::size_t, 3> size_;
  std::array<std::size_t, 3> at_{};
};

// Slices [first, first + slices.size()) of the axis, from one reading.
Result<void> fill(Volume& volume, std::size_t layer, std::size_t across, std::size_t first,
                  std::vector<Slice>& slices, const WatchedWork& work) {
  VoxelCounter at(volume.header().size);
  return volume.for_each_piece(layer, [&](std::span<const double> values) -> Result<void> {
    work.go_on();
    while (!values.empty()) {
      const std::span<const double> run = values.first(std::min(values.size(), at.row_left()));
      if (across == 1) {
        const std::size_t slice = at[1] - first;
        if (slice < slices.size()) slices[slice].append(run);
      } else {
        const std::size_t from = std::max(at[0], first);
        const std::size_t to = std::min(at[0] + run.size(), first + slices.size());
        for (std::size_t i = from; i < to; ++i) slices[i - first].append(run.subspan(i - at[0], 1));
      }
      at.go_on(run.size());
      values = values.subspan(run.size());
    }
    return {};
  });
}

Result<void> one_by_one(Volume& volume, std::size_t layer, Slice& slice, WatchedWork& work,
                        const std::function<Result<void>(std::size_t, Slice&)>& take) {
  VoxelCounter at(volume.header().size);
  return volume.for_each_piece(layer, [&](std::span<const double> values) -> Result<void> {
    work.go_on();
    while (!values.empty()) {
      const std::span<const double> run = values.first(std::min(values.size(), at.row_left()));
      const std::size_t index = at[2];
      slice.append(run);
      at.go_on(run.size());
      values = values.subspan(run.size());
      if (!slice.full()) continue;
      if (Result<void> taken = take(index, slice); !taken) return taken;
      slice.clear();
      work.step_done();
    }
    return {};
  });
}

}  // namespace

Result<void> for_each_slice(Volume& volume, std::size_t layer, const SlicePlacement& placed,
                            const RegionRule& rule, WatchedWork& work,
                            const std::function<Result<void>(std::size_t, Slice&)>& take) {
  const VolumeHeader& header = volume.header();
  const std::size_t width = header.size[placed.column_axis];
  const std::size_t height = header.size[placed.row_axis];
  const Slice none(width, height, rule);
  if (placed.across == 2) {
    Slice slice = none;
    return one_by_one(volume, layer, slice, work, take);
  }
  const std::size_t bytes = (width + 1) * height * (rule.iso ? 1 + sizeof(double) : 1);
  const std::size_t at_once = std::max<std::size_t>(1, kSliceBytes / bytes);
  for (std::size_t first = 0; first < header.size[placed.across]; first += at_once) {
    std::vector<Slice> slices(std::min(at_once, header.size[placed.across] - first), none);
    if (Result<void> read = fill(volume, layer, placed.across, first, slices, work); !read) {
      return read;
    }
    for (std::size_t i = 0; i < slices.size(); ++i) {
      TETLOFT_CHECK(slices[i].full());
      if (Result<void> taken = take(first + i, slices[i]); !taken) return taken;
      work.step_done();
    }
  }
  return {};
}

}  // namespace tetloft::internal::io
