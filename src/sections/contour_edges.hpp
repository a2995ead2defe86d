// The edges of a section's contours in a tree, and where points lie by them.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/overlap.hpp>
#include <tetloft/point.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

class ContourEdges {
 public:
  struct Edge {
    Point2 a, b;
  };
  enum class Where : std::uint8_t { outside, boundary, inside };

  explicit ContourEdges(const ConformingSection& section);
  /// The edges contour by contour, those of the outer one first.
  explicit ContourEdges(const RegionOutline& region);

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const BoxTree2& tree() const { return tree_; }
  [[nodiscard]] const Box2& box() const { return box_; }

  /// Where p lies with respect to the region: exactly, by the edges that a ray from it meets.
  [[nodiscard]] Where locate(const Point2& p) const;

 private:
  void build_tree();

  std::vector<Edge> edges_;
  Box2 box_;       // of all edges
  BoxTree2 tree_;  // over edges_
};

}  // namespace tetloft::internal::sections
