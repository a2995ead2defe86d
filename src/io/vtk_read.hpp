// Reading legacy VTK files.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

[[nodiscard]] Result<ReadModel> read_vtk(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
