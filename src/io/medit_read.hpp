// Solids of MEDIT's .mesh.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// As Format::read_model: the tetrahedra, whose references are components.
[[nodiscard]] Result<ReadModel> read_medit(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
