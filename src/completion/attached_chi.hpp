// Euler characteristics of what a complex attaches: its closed vertices, edges, triangles and tets
// (void_space.hpp). Pieces of the solid retract onto these.
#pragma once

#include <cstdint>
#include <vector>

#include "completion/complex.hpp"

namespace tetloft::internal {

/// Of each class; of one that is not active 0.
[[nodiscard]] IdVector<ClassId, std::int32_t> attached_chi(
    const Slab& slab, const SlabClasses& classes, const IdVector<ClassId, std::uint8_t>& active,
    const Complex& complex);

}  // namespace tetloft::internal
