// Which voxels of a volume are asked for.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "core/watched_work.hpp"
#include "io/volume/slice.hpp"
#include "io/volume/value_counts.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

struct ChosenRegion {
  std::size_t layer = 0;
  RegionRule rule;
  std::string name;  ///< of the segment; empty where it has none
};

/// Whether choose_region() counts voxels first, and of how many layers.
[[nodiscard]] std::size_t layers_to_count(const VolumeHeader& header, const ReadOptions& options);

/// options.structure names a segment by its name, or a label by its value; of files with several
/// volumes ("layers") a volume N, from 1 on, whose voxels are 0 and one other value, or N:V the
/// label V of it; with options.iso, the volume. Empty: the only label there is. Error usage that
/// tells what there is to choose from.
[[nodiscard]] Result<ChosenRegion> choose_region(Volume& volume, const std::string& name,
                                                 const ReadOptions& options, WatchedWork& work);

/// Why the region that was chosen has no voxels: all values are counted.
[[nodiscard]] Error empty_region(Volume& volume, const std::string& name,
                                 const ReadOptions& options, const ChosenRegion& region);

/// What options.structure may be, one after the other, so that every structure of a label volume is
/// read; `counts` are those of each layer.
[[nodiscard]] std::vector<std::string> structure_names(const VolumeHeader& header,
                                                       const std::vector<ValueCounts>& counts);

/// The name of a segment with this value, or empty.
[[nodiscard]] std::string segment_name(const VolumeHeader& header, std::size_t layer, double value);

}  // namespace tetloft::internal::io
