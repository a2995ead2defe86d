// Regions between two heights, made into the regions of all that is at least as high.
#pragma once

#include <vector>

#include <tetloft/result.hpp>

#include "io/drawing/drawing.hpp"

namespace tetloft::internal::io {

/// `lines` are closed, of constant z, and bound, by odd crossing number, regions without common
/// interior: one for each z, its points at least that high and lower than the next z. Replaces them
/// by lines that bound, at each z, the union of the regions there and above: of edges that two
/// regions share none is left, exactly; others, where neighbours divide their common border
/// differently, lie on each other (Drawing::may_touch). Other lines stay. What the file's lowest
/// region begins at is no level where it is farther below the next than any two others are apart:
/// writers begin at 0. Then it is left out, with a warning. Error invalid_input where the result
/// has more than kBandMultiple times the points.
inline constexpr std::size_t kBandMultiple = 8;
[[nodiscard]] Result<void> unite_bands(std::vector<DrawnLine>& lines,
                                       std::vector<Warning>& warnings);

}  // namespace tetloft::internal::io
