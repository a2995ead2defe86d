// A region moved in its plane.
#pragma once

#include <optional>

#include <tetloft/overlap.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

/// A region as a section of its own, of which contour 0 is the outer one.
struct MovedRegion {
  Section section;
  [[nodiscard]] RegionOutline outline() const;
};

/// The region with vertices (x + by.x, y + by.y), rounded. Nothing where rounding leaves no such
/// region.
[[nodiscard]] std::optional<MovedRegion> moved(const RegionOutline& region, const Point2& by);

}  // namespace tetloft::internal
