// The complement of a section as a section of its own: what the rules say of regions can be said of
// voids then. It is cut off at a square far outside, whose contour comes last. Its regions are the
// voids of the section: 0 is the exterior, holes follow by their lowest vertices; its holes are the
// section's outer contours.
#pragma once

#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

/// A void of a section, as a region of its complement.
inline constexpr RegionId kExterior{0U};

struct Complement {
  Section section;
  Nesting nesting;

  /// The hole that names a void; invalid for the exterior.
  [[nodiscard]] ContourId hole(RegionId of_void) const {
    return of_void == kExterior ? ContourId() : nesting.outer[of_void];
  }
};

/// Half the side of a square, about the origin, that is far larger than a stack: a power of two at
/// least four times its largest coordinate, so that areas beyond it dwarf those within.
[[nodiscard]] double far_outside(const SectionStack& stack);
/// The same of the largest magnitudes of stacks' or sections' coordinates.
[[nodiscard]] double far_outside(double largest);

/// Requires a valid section, its nesting, and far_outside() of its stack. Near-linear.
[[nodiscard]] Complement complement_of(const Section& section, const Nesting& nesting,
                                       double half_side);

/// The void that each contour bounds, on its outer side or, of a hole, its inner one; numbered as
/// above.
[[nodiscard]] IdVector<ContourId, RegionId> voids_of_contours(const Section& section,
                                                              const Nesting& nesting);

}  // namespace tetloft::internal::sections
