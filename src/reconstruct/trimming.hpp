// Trimming: lifted vertices that overhang are cut off again.
//
// A long external edge with both ends attached, as over a wide notch, has its midpoint far
// sideways of both regions: the solid grows a web there. A lifted vertex is a boundary
// vertex, so truncating it like a foreign corner changes no topology, and the cuts stay
// near the corners kept.
//
// For several vertices trimmed together, topology stays as it was while the subcomplex they
// span lies in the boundary surface and each of its components is collapsible. Vertices are
// taken by decreasing overshoot; one is refused
//   if it is joined to a trimmed one by an edge through the interior (two midpoints of one
//   type-2 tet attached at all corners), or
//   if it is joined, in the triangles left and right of its edge, to trimmed vertices of
//   one component twice: the component would close a cycle.
#pragma once

#include <cstdint>
#include <vector>

#include "reconstruct/lifting.hpp"

namespace tetloft {

/// Lifted vertices further sideways of both regions than this are trimmed, in gaps.
inline constexpr double kLargestOverhang = 0.5;

/// Per lifted vertex: trimmed? Requires settled lifting.
[[nodiscard]] std::vector<std::uint8_t> choose_trimmed(const Slab& slab, const Complex& complex,
                                                       const Subdivision& subdivision,
                                                       const Lifting& lifting);

}  // namespace tetloft
