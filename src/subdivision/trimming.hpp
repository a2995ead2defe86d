// Trimming: lifted vertices that overhang are cut off again.
//
// A long external edge with both ends attached, as over a wide notch, has its midpoint far
// sideways of both regions: the solid grows a web there. Such a vertex can be given the
// weight of a foreign corner, and the cuts then stay near the corners kept.
//
// The solid of a class is a regular neighbourhood of the full subcomplex F spanned by the
// nodes of weight 1. Taking a vertex out of F is a collapse if its link in F is
// collapsible, and neighbourhoods before and after are then homeomorphic. The link lies in
// a disc (the vertex is on the boundary), where collapsible means connected and of Euler
// characteristic 1. Vertices are taken one after the other, by decreasing overhang, each
// judged by what is left of F.
#pragma once

#include <cstdint>
#include <vector>

#include "subdivision/lifting.hpp"

namespace tetloft::internal {

/// Lifted vertices further sideways of both regions than this are trimmed, in gaps.
inline constexpr double kLargestOverhang = 0.5;

/// Which lifted vertices are trimmed. Requires settled lifting.
[[nodiscard]] IdVector<LiftedId, std::uint8_t> choose_trimmed(const Slab& slab,
                                                              const SlabClasses& classes,
                                                              const Complex& complex,
                                                              const Subdivision& subdivision,
                                                              const Lifting& lifting);

}  // namespace tetloft::internal
