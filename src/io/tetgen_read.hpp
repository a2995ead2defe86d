// Solids of TetGen.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// As Format::read_model, of an .ele with the .node beside it; region attributes are components.
[[nodiscard]] Result<ReadModel> read_tetgen(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
