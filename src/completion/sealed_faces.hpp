// VV faces that should be open and that a complex seals, and SS faces that should be solid and are
// not: by what D holds over a point well inside the face.
#pragma once

#include <vector>

#include <tetloft/point.hpp>

#include "completion/void_space.hpp"

namespace tetloft::internal {

/// The tets that a vertical line through a point of the plane meets, by id.
[[nodiscard]] std::vector<TetId> tets_over(const Slab& slab, const Point2& p);

/// Does the line stay in the void?
[[nodiscard]] bool is_open(const Slab& slab, const VoidSpace& space, const std::vector<TetId>& over,
                           const Point2& p);

}  // namespace tetloft::internal
