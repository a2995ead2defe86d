// Reading VTK XML poly data.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// Polylines; without any, polygons. A line whose first point id stands at its end again is closed,
/// and so is every polygon.
[[nodiscard]] Result<Drawing> read_vtp_lines(const Source& source, const ReadOptions& options);

/// All points, whatever refers to them.
[[nodiscard]] Result<ReadPoints> read_vtp_points(const Source& source, const ReadOptions& options);

/// Polygons; a warning tells of strips, which are left out.
[[nodiscard]] Result<ReadTriangles> read_vtp_triangles(const Source& source,
                                                       const ReadOptions& options);

/// The name of the cell data that tell of each line its section: files of stacks have them.
inline constexpr const char* kSectionOfLine = "section";

}  // namespace tetloft::internal::io
