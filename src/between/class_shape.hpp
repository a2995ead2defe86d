// The shape of one class between the two sections of a slab, sampled: signed distances that are
// moved and interpolated through four sections.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// The sections around a slab, from below.
enum Around : std::size_t { behind = 0, lower = 1, upper = 2, beyond = 3 };

/// One class of a slab in four sections in a row.
struct ClassOutlines {
  /// Of the class's regions in the slab's two sections, and of those linked with them in the
  /// sections behind and beyond; points of odd crossing number are inside. The class may be absent
  /// from any but one of the slab's two.
  std::array<std::vector<const Contour*>, 4> contours;
  /// Heights; behind and beyond none where the stack ends.
  std::array<std::optional<double>, 4> z;
};

/// Layers are the slab's lower section (0), the planes between in order, the upper section (last).
struct ClassShape {
  /// Of all layers; its border samples are outside in each of them. Sample (i, j) lies at
  /// (i · step, j · step).
  motion::LatticeWindow window;
  /// Signed distances by layer and sample, in steps: negative inside, never 0. Those of the given
  /// sections are the distances to their contours, exact up to what the README calls the reach, a
  /// step at least.
  std::vector<std::vector<double>> value;
  /// How the point at a sample moves from the lower to the upper plane, in steps; empty where the
  /// class is at rest.
  std::vector<Point2> motion;
};

/// Interpolates the class, as the README defines it, at shares `at` of the gap, in (0, 1),
/// increasing. With `rigid` (lower to
/// upper plane, in units of the stack) the class moves by that as a whole, else as its surroundings
/// in the four sections tell. A function of the set of contours: neither of their order nor of
/// where they start. No layers where a coordinate reaches 2^40 steps. Time and memory grow with the
/// samples in the class's box, so a step much smaller than its contours' edges is waste.
[[nodiscard]] ClassShape interpolate(const ClassOutlines& outlines, double step,
                                     const std::vector<double>& at,
                                     const std::optional<Point2>& rigid = std::nullopt);

}  // namespace tetloft::internal::between
