// Which contour of a section lies in which, and the regions they bound.
#pragma once

#include <cstdint>

#include <tetloft/export.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft {

/// The nesting of one valid section's contours.
struct Nesting {
  /// The innermost contour around it; invalid for outermost contours.
  IdVector<ContourId, ContourId> parent;
  /// Number of contours around it: even for outer contours, odd for holes.
  IdVector<ContourId, std::uint32_t> depth;
  /// The region that the contour bounds; regions are numbered by their outer contours in
  /// canonical order (lowest vertex).
  IdVector<ContourId, RegionId> region;
  IdVector<RegionId, ContourId> outer;  ///< the outer contour of a region
};

/// Requires a valid section: validate() tells. Throws std::invalid_argument for contours of fewer
/// than three vertices, or not finite.
[[nodiscard]] TETLOFT_API Nesting nest(const Section& section);

}  // namespace tetloft
