// The vertices and faces of .ply files.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// x, y and z of the element "vertex", of whichever types, as text or binary of either byte order;
/// other elements, and properties, which a warning tells of, are passed over.
[[nodiscard]] Result<ReadPoints> read_ply_points(const Source& source, const ReadOptions& options);

/// Those, and of the element "face" the list "vertex_indices" or "vertex_index".
[[nodiscard]] Result<ReadTriangles> read_ply_triangles(const Source& source,
                                                       const ReadOptions& options);

}  // namespace tetloft::internal::io
