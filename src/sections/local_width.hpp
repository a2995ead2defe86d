// How wide a section is at a point of its contours: by the discs that touch there.
#pragma once

#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

class LocalWidth {
 public:
  /// Of all contours of a section.
  explicit LocalWidth(const Section& section);

  /// The diameter of the largest disc that touches the edge a b, one of the section's, at its
  /// middle and holds nothing of the other edges, on the side where it is smaller; at most `most`.
  /// Rounded, but a function of the set of edges: neither of their order nor of their directions.
  [[nodiscard]] double at_middle(const Point2& a, const Point2& b, double most) const;

 private:
  struct Edge {
    Point2 low, high;
  };
  std::vector<Edge> edges_;
  BoxTree2 tree_;
};

}  // namespace tetloft::internal::sections
