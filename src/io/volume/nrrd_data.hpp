// Where the data of a NRRD file are: behind the header, or in files that it names.
#pragma once

#include <string>

#include <tetloft/result.hpp>

#include "io/format.hpp"
#include "io/volume/data_stream.hpp"
#include "io/volume/nrrd_header.hpp"
#include "io/volume/volume.hpp"

namespace tetloft::internal::io {

/// Encoding and parts of the data; type and byte order are set.
[[nodiscard]] Result<void> find_nrrd_data(const NrrdHeader& nrrd, const Source& source,
                                          const VolumeHeader& header, VoxelData& data);

}  // namespace tetloft::internal::io
