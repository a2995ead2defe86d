// Nesting found along a sweep, and the direction of a simple contour, which nesting, labels and
// overlap all need.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/overlap.hpp>

#include "sections/sweep.hpp"

namespace tetloft::internal::sections {

/// The nesting of contours, told by the sweep over their edges.
class Nester {
 public:
  /// Requires has_contours().
  explicit Nester(const Section& section);

  [[nodiscard]] std::span<const SweepEdge> edges() const { return edges_; }
  /// To be told every event in turn. Requires that no contours meet up to there.
  void see(const SweepEvent& event);
  /// Once all were told.
  [[nodiscard]] Nesting take() { return std::move(nesting_); }

 private:
  [[nodiscard]] bool is_inside_above(std::uint32_t edge) const {
    return forward_[edge] == ccw_[owner_[edge].index()];
  }

  std::vector<SweepEdge> edges_;
  std::vector<ContourId> owner_;  // by edge
  std::vector<bool> forward_;     // by edge: does its contour run from the lower to the higher end?
  std::vector<bool> seen_;        // by contour
  std::vector<bool> ccw_;         // by contour seen
  Nesting nesting_;
};

/// Does the contour run counter-clockwise? Requires a simple one; exact, linear.
[[nodiscard]] bool is_counter_clockwise(const Contour& contour);

/// What can be nested at all: contours of three finite vertices or more.
[[nodiscard]] bool has_contours(const Section& section);

}  // namespace tetloft::internal::sections
