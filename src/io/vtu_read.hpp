// Reading VTK XML unstructured grids.
#pragma once

#include "io/format.hpp"

namespace tetloft::io {

/// As read_vtu() in io.hpp.
[[nodiscard]] Result<ReadModel> read_vtu_source(const Source& source, const ReadOptions& options);

}  // namespace tetloft::io
