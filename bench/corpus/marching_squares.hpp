// Contours of one layer of samples.
#pragma once

#include <cstddef>

#include <tetloft/sections.hpp>

#include "corpus/solids.hpp"

namespace tetloft::bench {

struct MaskedSection {
  Section section;
  /// By contour: a sample just inside the region that it bounds, y · nx + x.
  IdVector<ContourId, std::size_t> sample;
};

/// Contours around the negative values of a layer of nx × ny samples at integer coordinates.
/// Samples that meet in a corner only are parted: inside is 4-connected. Requires the
/// outermost samples to be positive, and none to be zero.
[[nodiscard]] MaskedSection marching_squares(const float* value, std::size_t nx, std::size_t ny,
                                             Contouring contouring);

}  // namespace tetloft::bench
