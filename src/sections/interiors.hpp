// Do two regions share an open set? Predicates decide; no area is computed.
#pragma once

#include <tetloft/sections.hpp>

namespace tetloft::sections {

/// Is area(a ∩ b) positive? Touching boundaries, shared vertices and shared edges alone do
/// not count. Requires outlines of valid sections.
[[nodiscard]] bool interiors_meet(const RegionOutline& a, const RegionOutline& b);

}  // namespace tetloft::sections
