// The perimeter of a rectangle, cut by the ends of a section's open lines.
//
// The ends cut the perimeter into arcs that lie inside and outside of the region by turns, for
// each line parts inside from outside, and lines do not cross. So a section has two closings, and
// they are each other's complement in the rectangle. They are named by whether the rectangle's
// lowest corner (least x, least y) has inside before it, in counter-clockwise direction.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal::sections {

struct Rectangle {
  Point2 low, high;
};

/// Counter-clockwise from the lowest corner; a corner belongs to the side that begins there.
struct FramePosition {
  int side = 0;      ///< 0 at least y, 1 at largest x, 2 at largest y, 3 at least x
  double along = 0;  ///< the coordinate that varies, negated on sides 2 and 3
  friend auto operator<=>(const FramePosition&, const FramePosition&) = default;
};

/// Nothing for points off the perimeter.
[[nodiscard]] std::optional<FramePosition> position_on(const Rectangle& frame, const Point2& p);

struct OpenLineOnFrame {
  std::vector<Point2> points;
  ContourId of;
};

struct LineEnd {
  FramePosition at;
  std::size_t line = 0;
  bool last = false;  ///< of the line's points
};

/// A contour, and the one of the section that it is, or that it begins with; none for the
/// rectangle.
struct FramedContour {
  Contour contour;
  ContourId of;
};

struct FramedSection {
  std::vector<FramedContour> closed;
  std::vector<OpenLineOnFrame> lines;
  std::vector<LineEnd> ends;  ///< of all lines, by position; no two at one place
};

/// Drops what a line begins, or ends, with along one side of the frame: what is left may be
/// nothing.
void trim_along(const Rectangle& frame, std::vector<Point2>& line);

/// One of the two closings of a section.
[[nodiscard]] std::vector<FramedContour> closing(const FramedSection& section,
                                                 const Rectangle& frame, bool inside_before_corner);

}  // namespace tetloft::internal::sections
