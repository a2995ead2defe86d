// The method of distance fields: the signed distance to the contours of each section, linearly
// interpolated between sections (S. P. Raya and J. K. Udupa, Shape-based interpolation of
// multidimensional objects, IEEE Trans. Medical Imaging 9, 1990), on a regular grid.
#pragma once

#include <cstddef>

#include <tetloft/result.hpp>
#include <tetloft/sections.hpp>

#include "comparison/marching.hpp"

namespace tetloft::bench {

struct GridOptions {
  /// The step in the plane; 0: the mean length of contour edges, or, where that is less, the
  /// larger side of the contours' box in `least_steps` parts.
  double step = 0;
  double least_steps = 128;
  /// The step grows until there are no more samples than that.
  std::size_t most_samples = 2'000'000;
  /// Layers from one section to the next are about a step apart, but no more than this.
  std::size_t most_layers = 16;
};

/// The mean length of contour edges; 0 without any.
[[nodiscard]] double mean_edge_length(const SectionStack& stack);

/// Samples around all contours; each section's plane is a layer. Signs are those of the even-odd
/// rule, distances exact up to rounding. A section without contours is outside by the diagonal of
/// the grid. Refused (invalid_input): an invalid stack, fewer than two sections, no contours.
[[nodiscard]] Result<ScalarGrid> distance_field(const SectionStack& stack,
                                                const GridOptions& options = {});

}  // namespace tetloft::bench
