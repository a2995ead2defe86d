#include "subdivision/trimming_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetloft::internal {

namespace {

double distance_to_edge(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double along = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double magnitude(const Point2& p) { return std::max(std::abs(p.x), std::abs(p.y)); }

}  // namespace

RegionDistance::RegionDistance(const ConformingSection& section) : tree_({}) {
  std::vector<Box2> boxes;
  for (std::size_t k = 0; k < section.vertex_count(); ++k) {
    const PlaneVertexId v(k);
    if (!section.next[v].valid()) continue;
    const Edge edge{section.point(v), section.point(section.next[v])};
    edges_.push_back(edge);
    boxes.push_back(box_of(edge.a, edge.b));
    largest_ = std::max(largest_, magnitude(edge.a));
  }
  tree_ = BoxTree2(boxes);
}

/// More than distances and abscissae of points on edges are off by rounding: some ten roundings
/// of numbers up to twice the largest coordinates.
double RegionDistance::tolerance(const Point2& p) const {
  return 0x1p-44 * std::max(largest_, magnitude(p));
}

double RegionDistance::distance(const Point2& p, double enough) const {
  double best = std::numeric_limits<double>::infinity();
  const double tolerated = tolerance(p);
  tree_.query_nearest(
      p,
      [&](std::size_t e) { best = std::min(best, distance_to_edge(p, edges_[e].a, edges_[e].b)); },
      [&] { return best <= enough ? -1.0 : best + tolerated; });
  return best > enough && contains(p) ? 0 : best;
}

/// Odd number of edges to the right.
bool RegionDistance::contains(const Point2& p) const {
  bool inside = false;
  const Box2 right{p.x - tolerance(p), p.y, std::numeric_limits<double>::infinity(), p.y};
  tree_.query(right, [&](std::size_t e) {
    const auto& [a, b] = edges_[e];
    if ((a.y > p.y) == (b.y > p.y)) return;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  });
  return inside;
}

}  // namespace tetloft::internal
