#include "sections/contour_edges.hpp"

#include <algorithm>
#include <limits>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::sections {

ContourEdges::ContourEdges(const ConformingSection& section) : tree_({}) {
  std::vector<Box2> boxes;
  for (const PlaneVertexId v : section.next.ids()) {
    if (!section.next[v].valid()) continue;
    edges_.push_back({section.point(v), section.point(section.next[v])});
    boxes.push_back(box_of(edges_.back().a, edges_.back().b));
  }
  tree_ = BoxTree2(boxes);
}

ContourEdges::Where ContourEdges::locate(const Point2& p) const {
  bool on_edge = false;
  bool odd = false;
  // The ray goes in direction x. Ends of edges count as above it where they are on it.
  tree_.query({p.x, p.y, std::numeric_limits<double>::infinity(), p.y}, [&](std::size_t e) {
    const auto& [a, b] = edges_[e];
    const Sign side = orient2d(a, b, p);
    on_edge = on_edge || (side == Sign::zero && std::min(a.x, b.x) <= p.x);
    if ((a.y > p.y) == (b.y > p.y)) return;
    if ((side == Sign::positive) == (b.y > a.y)) odd = !odd;
  });
  if (on_edge) return Where::boundary;
  return odd ? Where::inside : Where::outside;
}

}  // namespace tetloft::internal::sections
