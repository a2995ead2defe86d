#include "sections/contour_edges.hpp"

#include <algorithm>
#include <limits>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::sections {

ContourEdges::ContourEdges(const ConformingSection& section) : tree_({}) {
  for (const PlaneVertexId v : section.next.ids()) {
    if (!section.next[v].valid()) continue;
    edges_.push_back({section.point(v), section.point(section.next[v])});
  }
  build_tree();
}

ContourEdges::ContourEdges(const RegionOutline& region) : tree_({}) {
  for (const Contour* contour : region.contours) {
    const std::vector<Point2>& vertices = contour->vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      edges_.push_back({vertices[v], vertices[v + 1 == vertices.size() ? 0 : v + 1]});
    }
  }
  build_tree();
}

void ContourEdges::build_tree() {
  std::vector<Box2> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& e : edges_) {
    boxes.push_back(box_of(e.a, e.b));
    box_.add(boxes.back());
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
