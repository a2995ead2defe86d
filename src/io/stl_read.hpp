// Reading .stl, binary and text.
#pragma once

#include <cstddef>
#include <string_view>

#include "io/format.hpp"

namespace tetloft::internal::io {

/// Of binary files: the head with the count of triangles, and each triangle.
inline constexpr std::size_t kStlHeadBytes = 84;
inline constexpr std::size_t kStlTriangleBytes = 50;

/// Whether the size is that which the count of triangles asks for: whatever the head says, which
/// some programs begin with "solid".
[[nodiscard]] bool is_binary_stl(std::string_view bytes);

/// Three points for each triangle, whatever its normal. Several solids in a text are one surface.
[[nodiscard]] Result<ReadTriangles> read_stl(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
