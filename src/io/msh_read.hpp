// Reading Gmsh's files, of either version.
#pragma once

#include <string_view>

#include "io/format.hpp"

namespace tetloft::internal::io {

[[nodiscard]] bool is_msh(std::string_view bytes);
[[nodiscard]] Result<ReadModel> read_msh(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
