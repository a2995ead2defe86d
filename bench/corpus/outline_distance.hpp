// How far regions lie from each other.
#pragma once

#include <tetloft/sections.hpp>

namespace tetloft::bench {

/// The least distance of edges of the two outlines, in doubles, or something above `reach` where
/// that is above `reach`. Requires outlines that do not overlap.
[[nodiscard]] double outline_distance(const RegionOutline& a, const RegionOutline& b, double reach);

}  // namespace tetloft::bench
