// Gates of a contour: short segments across what is not region, that cross no other.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>

#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

/// A contour with the region on its left, from its lowest vertex on; points may be added on edges.
struct Ring {
  std::vector<Point2> points;
  std::vector<bool> added;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t after(std::size_t k) const { return k + 1 == size() ? 0 : k + 1; }
  [[nodiscard]] std::size_t before(std::size_t k) const { return k == 0 ? size() - 1 : k - 1; }
};

/// Between two points of a ring, from < to.
struct Gate {
  std::size_t from = 0;
  std::size_t to = 0;
};

/// The edges of the other contours of a section, which gates must not meet.
struct OtherEdges {
  struct Edge {
    Point2 a, b;
  };
  std::vector<Edge> edges;
  std::vector<std::size_t> contour;  // by edge
  BoxTree2 tree{{}};
};

/// Adds to the ring the points of its edges that are nearest to a vertex across, at most `width`
/// away, where no vertex of the edge is so near; those of edges of contour `self` are left out of
/// `others`.
void add_feet(Ring& ring, double width);

/// Gates of at most `width`, the shortest first among those that would cross; each has more than
/// twice the width of the ring on either side.
[[nodiscard]] std::vector<Gate> find_gates(const Ring& ring, const OtherEdges& others,
                                           std::size_t self, double width);

}  // namespace tetloft::internal::sections
