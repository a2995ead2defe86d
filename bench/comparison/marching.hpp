// Isosurfaces by marching tetrahedra: each cell of the grid is parted into six tets around its
// diagonal (Freudenthal 1942; Kuhn 1960), the same way everywhere, so that the surface of the
// piecewise linear function is a closed manifold whatever the values.
#pragma once

#include <cstddef>
#include <vector>

#include "comparison/triangle_mesh.hpp"

namespace tetloft::bench {

/// Values on layers of nx × ny samples; inside where negative.
struct ScalarGrid {
  std::size_t nx = 0, ny = 0;
  Point2 origin;
  double step = 1;
  std::vector<double> z;     ///< of the layers, increasing
  std::vector<float> value;  ///< by layer, y, x
};

/// The zero surface between the first and the last layer, closed flat in their planes. Requires
/// that the outermost samples of every layer are outside.
[[nodiscard]] TriangleMesh marching_tets(const ScalarGrid& grid);

}  // namespace tetloft::bench
