// How far a point is from a section's region.
//
// Near-linear in all for many points: the edges of the contours lie in a box tree.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/point.hpp>

#include "sections/contour_edges.hpp"

namespace tetloft::internal {

class RegionDistance {
 public:
  explicit RegionDistance(const ConformingSection& section);

  /// Does p lie in the closed region? Exact.
  [[nodiscard]] bool contains(const Point2& p) const;

  /// Distance from p to the contours, rounded; infinite without any. Where it is at most `enough`,
  /// some distance up to `enough`. What is returned beyond `enough` is the least of all edges as
  /// rounded, whatever the tree.
  [[nodiscard]] double distance(const Point2& p, double enough) const;

 private:
  [[nodiscard]] double tolerance(const Point2& p) const;

  sections::ContourEdges contours_;
  double largest_ = 0;  // coordinate of theirs
};

}  // namespace tetloft::internal
