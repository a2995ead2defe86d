// Signed distances to the contours of a section, sampled on a window of a square lattice.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::internal {

/// A window of a square lattice: sample (i, j) lies at origin + (i, j) · step.
struct LatticeWindow {
  Point2 origin;
  double step = 1;
  std::size_t nx = 0, ny = 0;
  [[nodiscard]] std::size_t size() const { return nx * ny; }
  [[nodiscard]] double x(std::size_t i) const { return origin.x + static_cast<double>(i) * step; }
  [[nodiscard]] double y(std::size_t j) const { return origin.y + static_cast<double>(j) * step; }
};

/// The signed distances of the window's samples, row by row, to the edges of the contours:
/// negative at points of odd crossing number, no farther than limit on either side.
/// Depends on the set of edges only, not on their order or direction.
[[nodiscard]] std::vector<double> signed_distances(std::span<const Contour* const> contours,
                                                   const LatticeWindow& window, double limit);

}  // namespace tetloft::internal
