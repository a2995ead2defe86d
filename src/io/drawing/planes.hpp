// The parallel planes in which the lines of a drawing lie, and the turn that makes them planes of
// constant z.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/frame.hpp>
#include <tetloft/point.hpp>

#include "io/drawing/drawing.hpp"

namespace tetloft::internal::io {

using PointsOfLine = const std::vector<Point3>*;

struct PlanesOfLines {
  Frame frame;  ///< from the stack's coordinates to the file's
  /// By line: the range of its heights in the stack.
  std::vector<double> low;
  std::vector<double> high;
  double usual_gap =
      0;  ///< half of the height lies in gaps that are at least as large; 0: one plane
  double tolerance = 0;            ///< heights within it are one plane
  std::vector<double> height;      ///< of each plane, ascending: that of most of its lines
  std::vector<std::size_t> plane;  ///< by line
};

/// The common direction of all lines is that of the axis along which no line extends, within the
/// tolerance; else that of the sum of their area vectors. Tolerance: `asked`, or the larger of
/// kDefaultPlaneTolerance of the usual gap and 2^-20 of the largest extent. Lines that extend
/// farther along it than the tolerance are not in a plane of the stack: off_plane() finds them.
/// `lines` are not empty, nor is any of them.
[[nodiscard]] PlanesOfLines planes_of(const std::vector<PointsOfLine>& lines,
                                      const std::optional<double>& asked);

/// What is asked for, or what the drawing means.
[[nodiscard]] std::optional<double> plane_tolerance(const Drawing& drawing,
                                                    const std::optional<double>& asked);

/// The line that extends farthest across its plane, beyond the tolerance; none if all are in
/// planes.
[[nodiscard]] std::optional<std::size_t> off_plane(const PlanesOfLines& planes);

/// What x and y of a stack are multiples of: 0, or where the planes are oblique, so that turning
/// rounds, 2^-32 of the largest coordinate. Points that were in line before the turn are in line
/// again, most of them; the rest lie far enough beside it that turning back, which rounds to 2^-53,
/// turns nothing over.
[[nodiscard]] double lattice_of(const PlanesOfLines& planes,
                                const std::vector<PointsOfLine>& lines);

/// The coordinates of the stack of a point of the file.
[[nodiscard]] Point3 unplace(const Frame& frame, const Point3& point);

/// Twice the area vector of a closed line (Newell).
[[nodiscard]] Point3 area_vector(const std::vector<Point3>& points);

}  // namespace tetloft::internal::io
