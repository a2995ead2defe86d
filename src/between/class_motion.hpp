// How a class moves through a slab, from place to place.
#pragma once

#include <optional>
#include <vector>

#include <tetloft/point.hpp>

#include "between/class_shape.hpp"
#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// How points half-way between the planes move from the lower to the upper one, at the nodes of a
/// coarse lattice.
struct MotionField {
  /// Two nodes along each axis at least; node (i, j) lies at (i · spacing, j · spacing).
  motion::LatticeWindow window;
  double spacing = 0;
  std::vector<Point2> node;
  /// Bilinear between nodes; outside the window that of its border.
  [[nodiscard]] Point2 at(const Point2& p) const;
  /// At the samples (i · step, j · step) of a window, row by row.
  [[nodiscard]] std::vector<Point2> at_samples(const motion::LatticeWindow& samples,
                                               double step) const;
};

/// The motion of a class around its regions in the slab's two sections, as the README defines it,
/// in units of the stack; none where the class is at rest, or nothing tells. Requires coordinates
/// below 2^40 quarters of the gap.
[[nodiscard]] std::optional<MotionField> estimate_motion(const ClassOutlines& outlines);

}  // namespace tetloft::internal::between
