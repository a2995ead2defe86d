// Signed distances to the contours of a section, sampled on the lattice of a slab.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "motion/lattice_window.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::motion {

/// Distances are followed as far as this where motions are estimated, in lattice units: one gap.
inline constexpr double kFarthest = kStepsPerGap;

/// The edges of a section's contours in lattice units, each with its ends in canonical order.
class LatticeEdges {
 public:
  struct Edge {
    Point2 a, b;
    Point2 past_a, past_b;  ///< the other ends of the edges that come before a and after b
  };
  struct Part {
    Box2 box;
    std::size_t end = 0;  // behind its last edge
  };

  LatticeEdges() = default;
  LatticeEdges(const Section& section, double step);
  LatticeEdges(const std::vector<const Contour*>& contours, double step);

  [[nodiscard]] bool empty() const { return contours_.empty(); }
  /// The bounds of all contours.
  [[nodiscard]] const Box2& box() const { return box_; }
  /// The longest extent of an edge along an axis.
  [[nodiscard]] double longest() const { return longest_; }
  /// Calls visit(edge) for the edges of every contour that comes within `reach` of the window.
  template <class Visit>
  void visit_near(const LatticeWindow& window, double reach, const Visit& visit) const {
    const Box2 near = reached_from(window, reach);
    std::size_t first = 0;
    for (const Part& contour : contours_) {
      if (contour.box.meets(near)) {
        for (std::size_t e = first; e < contour.end; ++e) visit(edges_[e]);
      }
      first = contour.end;
    }
  }

 private:
  void add(const Contour& contour, double step);
  [[nodiscard]] static Box2 reached_from(const LatticeWindow& window, double reach);

  std::vector<Edge> edges_;
  std::vector<Part> contours_;
  Box2 box_;
  double longest_ = 0;
};

struct DistanceSamples {
  /// Samples of a tile along each axis, from the first of the window on.
  static constexpr std::size_t kTile = 8;

  LatticeWindow window;
  std::vector<double> value;  // by window.place()
  /// By tile, row by row: 0 where all samples are as far as they can be, on one side.
  std::vector<std::uint8_t> near;
  [[nodiscard]] std::size_t tiles_in_row() const { return (window.nx() + kTile - 1) / kTile; }
  [[nodiscard]] const double* at(std::int64_t i, std::int64_t j) const {
    return value.data() + window.place(i, j);
  }
};

/// The signed distances of the window's samples to the edges, in lattice units: negative at points
/// of odd crossing number, and `farthest` at most on either side. A sample depends on the set of
/// edges alone: neither on their order nor on the window. Requires coordinates below 2^40 in
/// lattice units.
[[nodiscard]] DistanceSamples sample_distances(const LatticeEdges& edges,
                                               const LatticeWindow& window,
                                               double farthest = kFarthest);

/// The samples of the window whose distance would be negative, without those distances.
class InsideSamples {
 public:
  /// Of one row, from the first to before the end.
  struct Run {
    std::int64_t first, end;
  };
  InsideSamples(const LatticeEdges& edges, const LatticeWindow& window);

  /// Those of row j, ascending.
  [[nodiscard]] std::span<const Run> row(std::int64_t j) const {
    const auto k = static_cast<std::size_t>(j - j0_);
    return {runs_.data() + begin_[k], runs_.data() + begin_[k + 1]};
  }

 private:
  std::int64_t j0_;
  std::vector<std::size_t> begin_;  // by row, and behind the last
  std::vector<Run> runs_;
};

}  // namespace tetloft::internal::motion
