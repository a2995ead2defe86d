// The contours of a slice: disjoint simple closed loops by construction.
//
// Between a pixel inside the region and a neighbour (of four) outside runs a crack. Cracks are
// followed with the inside to the left. Where four pixels meet of which two, diagonally opposite,
// are inside, the loops part them: regions are connected over edges of pixels, what is outside over
// corners, too. So each crack has one successor and one predecessor, and belongs to one loop.
//
// Sub-pixel: a vertex for each crack, between the centres of its two pixels, neither of them. In a
// square of four centres, edges of loops join points strictly inside its sides: one edge, or two
// that cut off opposite corners on either side of its diagonal. Nothing meets.
//
// Lattice: vertices where cracks turn, at corners of pixels. Where loops part diagonal pixels, each
// corner is cut off by a quarter of a pixel.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <tetloft/formats.hpp>

#include "io/volume/slice.hpp"

namespace tetloft::internal::io {

/// In units of pixels, whose centres are integers.
struct PixelPoint {
  double column = 0;
  double row = 0;
};

/// The part of a corner that is cut off where the loops of diagonal pixels would touch.
inline constexpr double kCutCorner = 0.25;

/// Calls `take` with each loop, in the order of their lowest rows, then columns; holes run
/// clockwise. The slice is full, and is marked as passed.
void trace_contours(Slice& slice, VolumeContours way,
                    const std::function<void(const std::vector<PixelPoint>&)>& take);

}  // namespace tetloft::internal::io
