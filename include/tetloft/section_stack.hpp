// Stacks of planar cross sections: values, and what makes them valid.
//
// Section i is the plane z = z_i with disjoint simple closed contours; its region is the
// set of points of odd crossing number. A connected region is an outer contour with its
// immediate holes.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/description.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/export.hpp>
#include <tetloft/frame.hpp>
#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/predicates.hpp>
#include <tetloft/result.hpp>

namespace tetloft {

/// A closed polygon in either direction; the first vertex is not repeated at the end.
struct Contour {
  std::vector<Point2> vertices;
};

struct Section {
  double z = 0;
  IdVector<ContourId, Contour> contours;
};

/// Sections by increasing z.
struct TETLOFT_API SectionStack {
  IdVector<SectionId, Section> sections;
  /// Where the stack lies in the space of its file; what is made of it lies there, too. No
  /// coordinate here is in that space but by place().
  Frame frame = {};
  Description about = {};
  [[nodiscard]] std::size_t contour_count() const;
  [[nodiscard]] std::size_t vertex_count() const;
};

/// Constructed points (midpoints, lifted and cut points) neither over- nor underflow as
/// long as input coordinates stay below this.
inline constexpr double kLargestCoordinate = 0x1p1000;

/// Verifies, exactly: at least one section and one contour; z strictly increasing; all coordinates
/// finite and of magnitude below kLargestCoordinate; contours simple, with at least three vertices
/// and non-zero area, pairwise without contact. The error names section, contour, vertex,
/// coordinates and the reason; the first defect by (section, contour, vertex) is reported. O(n log
/// n) for contours without long-range contact. Threads share the sections.
[[nodiscard]] TETLOFT_API Result<void> validate(const SectionStack& stack,
                                                const Execution& execution = {});

/// Twice the signed area of a closed polygon (positive iff counter-clockwise), rounded.
[[nodiscard]] TETLOFT_API double twice_area(const Contour& contour);
/// The exact sign of it.
[[nodiscard]] TETLOFT_API Sign area_sign(const Contour& contour);

}  // namespace tetloft
