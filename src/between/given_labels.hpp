// The nodes of a given layer: they come from its contours, not from samples, which would lose what
// is thinner than the lattice.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/ids.hpp>
#include <tetloft/nesting.hpp>
#include <tetloft/section_stack.hpp>

#include "between/layer_labels.hpp"
#include "motion/lattice_window.hpp"

namespace tetloft::internal::between {

/// A class in one of the slab's sections, on the lattice.
struct GivenRegions {
  const Section& section;
  const Nesting& nesting;
  const std::vector<RegionId>& regions;
  double step = 0;
};

struct GivenLabels {
  /// Node n is regions[n]. It has the samples within it, and those nearer to it than 0.72 steps
  /// that are in none; or one sample of another region's, if that can spare it.
  LayerLabels solids;
  /// The exterior, and each hole contour with what is in it and in none of the regions inside that
  /// hole.
  LayerLabels voids;
};

[[nodiscard]] GivenLabels label_given(const GivenRegions& given,
                                      const motion::LatticeWindow& window);

}  // namespace tetloft::internal::between
