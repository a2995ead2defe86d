#include "corpus/outline_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "spatial/box_tree.hpp"

namespace tetloft::bench {

namespace {

using internal::Box2;
using Segment = std::pair<Point2, Point2>;

Box2 wide_box(const RegionOutline& region, double reach) {
  Box2 box;
  for (const Point2& p : region.contours.front()->vertices) box.add(p);
  return {box.x0 - reach, box.y0 - reach, box.x1 + reach, box.y1 + reach};
}

std::vector<Segment> edges_in(const RegionOutline& region, const Box2& box) {
  std::vector<Segment> result;
  for (const Contour* contour : region.contours) {
    Point2 last = contour->vertices.back();
    for (const Point2& p : contour->vertices) {
      if (internal::box_of(last, p).meets(box)) result.emplace_back(last, p);
      last = p;
    }
  }
  return result;
}

double squared_distance(const Point2& p, const Segment& s) {
  const double dx = s.second.x - s.first.x;
  const double dy = s.second.y - s.first.y;
  const double x = p.x - s.first.x;
  const double y = p.y - s.first.y;
  const double t = std::clamp((x * dx + y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return (x - t * dx) * (x - t * dx) + (y - t * dy) * (y - t * dy);
}

}  // namespace

double outline_distance(const RegionOutline& a, const RegionOutline& b, double reach) {
  double least = 4 * reach * reach;
  const std::vector<Segment> others = edges_in(b, wide_box(a, reach));
  for (const Segment& s : edges_in(a, wide_box(b, reach))) {
    for (const Segment& t : others) {
      // Segments that do not cross are nearest at an end of one.
      least = std::min({least, squared_distance(s.first, t), squared_distance(s.second, t),
                        squared_distance(t.first, s), squared_distance(t.second, s)});
    }
  }
  return std::sqrt(least);
}

}  // namespace tetloft::bench
