// The slices of a volume across any of its axes, in memory for a few of them.
#pragma once

#include <cstddef>
#include <functional>

#include <tetloft/result.hpp>

#include "core/watched_work.hpp"
#include "io/volume/placement.hpp"
#include "io/volume/slice.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// What slices take of memory at a time, unless one alone takes more.
inline constexpr std::size_t kSliceBytes = std::size_t{32} << 20;

/// Calls `take` with each slice across placed.across of `layer`, ascending, full. Slices across the
/// slowest axis are read one by one; for others the volume is read several times, each time as many
/// slices as memory allows. `work` is told each slice.
[[nodiscard]] Result<void> for_each_slice(
    Volume& volume, std::size_t layer, const SlicePlacement& placed, const RegionRule& rule,
    WatchedWork& work, const std::function<Result<void>(std::size_t index, Slice& slice)>& take);

}  // namespace tetloft::internal::io
