// Signed distances to the contours of a section, sampled on a lattice.
#pragma once

#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal {

/// The edges of a section's contours in units of the lattice's step, each with its ends in
/// canonical order.
class LatticeEdges {
 public:
  struct Edge {
    Point2 a, b;
  };
  LatticeEdges(const Section& section, double step);

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  /// Of all of them.
  [[nodiscard]] const Box2& box() const { return box_; }

 private:
  std::vector<Edge> edges_;
  Box2 box_;
};

/// Samples of a window, row by row.
struct DistanceSamples {
  LatticeWindow window;
  std::vector<double> value;
  [[nodiscard]] const double* at(std::int64_t i, std::int64_t j) const {
    return value.data() + static_cast<std::size_t>(j - window.j0) * window.nx() +
           static_cast<std::size_t>(i - window.i0);
  }
};

/// The signed distances of the window's samples to the edges: negative at points of odd crossing
/// number, and `limit` at most on either side. A sample depends on the set of edges alone, neither
/// on their order nor on the window.
[[nodiscard]] DistanceSamples sample_distances(const LatticeEdges& edges,
                                               const LatticeWindow& window, double limit);

}  // namespace tetloft::internal
