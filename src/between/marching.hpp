// Contours of sampled values: marching squares (Lorensen and Cline, SIGGRAPH 1987, in the plane).
// Insides are 4-connected: of two inside samples across a diagonal the contour parts one from the
// other.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/section_stack.hpp>

#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

struct TracedContour {
  Contour contour;           ///< the inside to the left; starts at the lowest vertex
  std::uint32_t sample = 0;  ///< the place of an inside sample along it
};

/// The contours of the negative values, sorted by their lowest vertices. Crossings are linear along
/// lattice edges, and at least a 64th of a step from either sample. Requires that the window's
/// border is outside.
[[nodiscard]] std::vector<TracedContour> trace_contours(const motion::LatticeWindow& window,
                                                        const std::vector<double>& value,
                                                        double step);

}  // namespace tetloft::internal::between
