// Do two regions share an open set? Predicates decide; no area is computed.
#pragma once

#include <tetloft/sections.hpp>

#include "sections/box_tree.hpp"

namespace tetloft::sections {

/// The bounding box of a region.
[[nodiscard]] Box bounds(const RegionOutline& region);

/// Is area(a ∩ b) positive? Touching boundaries, shared vertices and shared edges alone do
/// not count. Requires outlines of valid sections.
[[nodiscard]] bool interiors_meet(const RegionOutline& a, const RegionOutline& b);

}  // namespace tetloft::sections
