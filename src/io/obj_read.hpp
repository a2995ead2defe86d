// Reading surfaces of Wavefront .obj.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// Faces of whatever number of corners; groups, materials, normals, lines and the like are passed
/// over.
[[nodiscard]] Result<ReadTriangles> read_obj(const Source& source, const ReadOptions& options);

}  // namespace tetloft::internal::io
