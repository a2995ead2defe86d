// STL holds float32 only: vertices that differ as doubles may coincide there, and triangles
// lose their area.
#pragma once

#include <string>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/result.hpp>

#include "io/pending_file.hpp"
#include "io/surface.hpp"

namespace tetloft::io {

/// What rounding to float32 breaks, decided exactly: one warning if distinct vertices merge
/// and one if triangles become flat, each naming the first
/// place. Error invalid_input where a coordinate is beyond float32.
[[nodiscard]] Result<std::vector<Warning>> check_float32(const SurfaceMesh& mesh,
                                                         const std::string& path);

/// Requires that check_float32 gave no error.
void append_stl(PendingFile& file, const SurfaceMesh& mesh, Encoding encoding);

}  // namespace tetloft::io
