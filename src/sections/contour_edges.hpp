// The edges of a section's contours in a tree, and where points lie by them.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/conforming_section.hpp>
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

  [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }
  [[nodiscard]] const BoxTree2& tree() const { return tree_; }

  /// Where p lies with respect to the region: exactly, by the edges that a ray from it meets.
  [[nodiscard]] Where locate(const Point2& p) const;

 private:
  std::vector<Edge> edges_;
  BoxTree2 tree_;  // over edges_
};

}  // namespace tetloft::internal::sections
