// How far a point is from a section's region.
//
// Near-linear in all for many points: the edges of the contours lie in a box tree.
#pragma once

#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/point.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal {

class RegionDistance {
 public:
  explicit RegionDistance(const ConformingSection& section);

  /// Distance from p to the region, rounded, 0 inside; infinite without contours. Where it is at
  /// most `enough`, some distance up to `enough`. What is returned beyond `enough` is the least of
  /// all edges as rounded, whatever the tree.
  [[nodiscard]] double distance(const Point2& p, double enough) const;

 private:
  struct Edge {
    Point2 a, b;
  };
  [[nodiscard]] double tolerance(const Point2& p) const;
  [[nodiscard]] bool contains(const Point2& p) const;

  std::vector<Edge> edges_;  // of contours
  BoxTree2 tree_;            // over edges_
  double largest_ = 0;       // coordinate of theirs
};

}  // namespace tetloft::internal
