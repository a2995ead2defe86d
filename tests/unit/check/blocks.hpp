// Solids of unit squares in layers, as pictures, to check and to corrupt where columns
// (columns.hpp) have not enough shape: with cavities, tunnels, bars.
#pragma once

#include <string>
#include <vector>

#include "unit/check/columns.hpp"

namespace tetloft::testing {

/// Rows of squares: '#' is solid. Column i of row j covers [i, i + 1] × [j, j + 1].
using Picture = std::vector<std::string>;

/// Each picture from one height to the next; a section between two pictures with `planes`, whose
/// contours are given (the pictures on its two sides show them), and so where the solid begins or
/// ends in a plane. Cubes are cut along their diagonals, so that all fit.
struct Layers {
  std::vector<double> heights;
  std::vector<Picture> pictures;  ///< one less
  std::vector<Section> sections;
};
[[nodiscard]] Case build(const Layers& layers);

}  // namespace tetloft::testing
