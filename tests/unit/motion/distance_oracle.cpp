#include "unit/motion/distance_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetloft::testing {

double distance_by_all_edges(const Section& section, double step, const Point2& at,
                             double farthest) {
  double least = farthest * farthest;
  bool inside = false;
  for (const Contour& contour : section.contours) {
    for (std::size_t v = 0; v < contour.vertices.size(); ++v) {
      const Point2& p = contour.vertices[v];
      const Point2& q = contour.vertices[(v + 1) % contour.vertices.size()];
      Point2 a{p.x / step, p.y / step};
      Point2 b{q.x / step, q.y / step};
      if (a == b) continue;
      if (canonical_less(b, a)) std::swap(a, b);
      const Point2 d{b.x - a.x, b.y - a.y};
      const Point2 from{at.x - a.x, at.y - a.y};
      const double t =
          std::clamp((from.x * d.x + from.y * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
      const Point2 e{from.x - t * d.x, from.y - t * d.y};
      least = std::min(least, e.x * e.x + e.y * e.y);
      if (a.y > b.y) std::swap(a, b);
      if (a.y <= at.y && at.y < b.y && a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x) <= at.x) {
        inside = !inside;
      }
    }
  }
  return inside ? -std::sqrt(least) : std::sqrt(least);
}

}  // namespace tetloft::testing
