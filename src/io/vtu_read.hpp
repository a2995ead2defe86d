// Reading VTK XML unstructured grids.
#pragma once

#include <cstdint>

#include "io/format.hpp"

namespace tetloft::internal::io {

/// A tetrahedron, among the types of VTK's cells.
inline constexpr std::uint8_t kVtkTetra = 10;

/// As read_vtu() in io.hpp.
[[nodiscard]] Result<ReadModel> read_vtu_source(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
