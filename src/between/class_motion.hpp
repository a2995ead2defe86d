// How a class moves through a slab, from place to place.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tetloft/point.hpp>

#include "between/class_shape.hpp"
#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// How points move from the lower to the upper plane, at the nodes of a coarse lattice.
struct MotionField {
  /// Nodes (i, j) lie at (i, j) · spacing.
  motion::LatticeWindow window;
  double spacing = 0;
  std::vector<Point2> node;
  /// The longest motion along either axis.
  [[nodiscard]] double longest() const;
  /// Bilinear between nodes; outside the window as at the nearest node.
  [[nodiscard]] Point2 at(const Point2& p) const;
};

/// The motion of a class, in units of the stack, around its regions in the slab's two sections, as
/// the README defines it; none where the class is at rest. Requires coordinates below 2^40 gaps.
[[nodiscard]] std::optional<MotionField> estimate_motion(const ClassOutlines& outlines);

}  // namespace tetloft::internal::between
