// From a volume to a stack: the contours of a label, or at an iso-value, slice by slice.
#pragma once

#include <string>

#include <tetloft/formats.hpp>
#include <tetloft/inspect.hpp>

#include "io/stack_of_file.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// `name` stands for the file in messages. Errors: usage where options.structure names none of the
/// labels, or one of several must be named; invalid_input where no voxel is in the region.
[[nodiscard]] Result<StackOfFile> stack_of_volume(Volume& volume, const std::string& name,
                                                  const ReadOptions& options);

/// Counts all voxels.
[[nodiscard]] Result<FileSummary> summary_of_volume(Volume& volume, const ReadOptions& options);

}  // namespace tetloft::internal::io
