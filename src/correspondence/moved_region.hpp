// A region moved in its plane.
#pragma once

#include <optional>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>

namespace tetloft::internal {

/// A region as a section of its own; contour 0 is the outer one.
struct MovedRegion {
  Section section;
  Nesting nesting;
  [[nodiscard]] RegionOutline outline() const {
    return tetloft::outline(section, nesting, RegionId(0));
  }
};

/// The region with vertices (x + by.x, y + by.y), rounded. Nothing where rounding leaves no such
/// region.
[[nodiscard]] std::optional<MovedRegion> moved(const RegionOutline& region, const Point2& by);

}  // namespace tetloft::internal
