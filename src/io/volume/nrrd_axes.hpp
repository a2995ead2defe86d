// The axes of a NRRD array: which are axes of space, and where these lie.
#pragma once

#include <cstdint>
#include <string>

#include <tetloft/result.hpp>

#include "io/volume/nrrd_header.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// Sets sizes, layers, spacing, matrix, space and unit. World coordinates are those of the file's
/// `space`; where it names none, those of axis mins and spacings. Of fewer than three axes of space
/// the others have one voxel. Returns how many voxels of a layer stand together.
[[nodiscard]] Result<std::uint64_t> set_nrrd_axes(const NrrdHeader& nrrd, VolumeHeader& header);

}  // namespace tetloft::internal::io
