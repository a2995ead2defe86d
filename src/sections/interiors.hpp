// Do two regions share an open set? Predicates decide; no area is computed.
#pragma once

#include <tetloft/overlap.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

/// The bounding box of a region.
[[nodiscard]] Box2 bounds(const RegionOutline& region);

/// Is area(a ∩ b) positive? Touching boundaries, shared vertices and shared edges alone do
/// not count. Requires outlines of valid sections.
[[nodiscard]] bool interiors_meet(const RegionOutline& a, const RegionOutline& b);
/// The same with their bounds() at hand.
[[nodiscard]] bool interiors_meet(const RegionOutline& a, const Box2& box_a, const RegionOutline& b,
                                  const Box2& box_b);

/// Throws std::invalid_argument unless all coordinates are finite.
void require_finite(const Contour& contour);
/// The same for an outline, which has a contour at least, and none that is null.
void require_outline(const RegionOutline& region);

}  // namespace tetloft::internal::sections
