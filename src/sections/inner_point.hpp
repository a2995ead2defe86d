// A point well inside a face of an overlay.
#pragma once

#include <optional>

#include "sections/face_overlay.hpp"

namespace tetloft::internal::sections {

/// Of the incentres of the Delaunay triangles of the border's points, which are rounded, that of
/// the largest incircle among those that lie in the face, exactly; nothing where none does.
[[nodiscard]] std::optional<Point2> inner_point(const FaceOverlay& overlay, FaceId face);

}  // namespace tetloft::internal::sections
