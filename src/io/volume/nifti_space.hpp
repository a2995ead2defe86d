// Where the voxels of a NIfTI file lie.
#pragma once

#include <array>
#include <string>

#include <tetloft/result.hpp>

#include "io/volume/nifti_header.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// Sets matrix, spacing, space and unit, and warns of what had to be decided: the sform counts if
/// its code is above 0 and its axes are not coplanar, else the qform if its code is above 0, else
/// the voxel sizes alone, from the origin, without a flip.
[[nodiscard]] Result<void> set_nifti_space(const NiftiHeader& nifti, const std::string& name,
                                           VolumeHeader& header);

}  // namespace tetloft::internal::io
