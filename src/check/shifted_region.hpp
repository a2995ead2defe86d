// A region somewhere else in its plane, as rules 1 and 2 move it.
#pragma once

#include <optional>

#include <tetloft/overlap.hpp>

#include "check/box_tree.hpp"

namespace tetloft::internal::checking {

struct ShiftedRegion {
  Section section;
  Box2 box;
  [[nodiscard]] RegionOutline shape() const;
};

/// The region with vertices (x + dx, y + dy), rounded; none where it is no region any more: not
/// valid as a section, or nested otherwise.
[[nodiscard]] std::optional<ShiftedRegion> shifted(const RegionOutline& region, const Point2& d);

}  // namespace tetloft::internal::checking
