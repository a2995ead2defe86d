// A periodic Delaunay triangulation around one cell, out of finitely many images.
//
// A tet of the images is one of the infinite set if its closed ball lies in the region of which all
// images are there: the perturbed predicates ask no more of points than that. Where all tets of the
// points in the cell are such, their stars are closed, so there are no others. At two covering
// radii around the cell that always holds: a point's Voronoi cell reaches no farther than one, as
// it is in that of its own images; its tets' balls, which are as large and touch the point, no
// farther than two.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

#include "periodic/lattice.hpp"

namespace tetloft::internal::periodic {

/// Images of the wrapped points: first those in the cell, in order, then others.
struct Cover {
  std::size_t in_cell = 0;
  std::vector<Point3> points;
  std::vector<std::uint32_t> point_of;             ///< whose image
  std::vector<std::array<std::int32_t, 3>> shift;  ///< in the reduced basis
  TetMesh mesh;  ///< of which the stars of points in the cell are those of the infinite set
};
/// Refused (invalid_input) where two points are images of each other, (work_limit) where it takes
/// too many. Requires points.
[[nodiscard]] Result<Cover> covered(const Lattice& lattice, const WrappedPoints& wrapped,
                                    const Execution& execution);

}  // namespace tetloft::internal::periodic
