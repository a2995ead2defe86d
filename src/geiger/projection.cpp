#include "geiger/projection.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "sections/contour_edges.hpp"

namespace tetloft::internal::geiger {

namespace {

constexpr double kNear = 0.1;

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double s = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

// A section's contours, and what is near: a share of their mean edge.
class Interior {
 public:
  explicit Interior(const ConformingSection& section) : contours_(section) {
    double sum = 0;
    for (const auto& [a, b] : contours_.edges()) sum += std::hypot(b.x - a.x, b.y - a.y);
    near_ = kNear * sum / static_cast<double>(contours_.edges().size());
  }

  [[nodiscard]] double near() const { return near_; }

  [[nodiscard]] bool is_well_inside(const Point2& p) const {
    if (contours_.locate(p) != sections::ContourEdges::Where::inside) return false;
    bool well = true;
    contours_.tree().query({p.x - near_, p.y - near_, p.x + near_, p.y + near_},
                           [&](std::size_t e) {
                             const auto& [a, b] = contours_.edges()[e];
                             well = well && distance_to_segment(p, a, b) >= near_;
                           });
    return well;
  }

 private:
  sections::ContourEdges contours_;
  double near_ = 0;
};

}  // namespace

std::vector<Point2> external_skeleton_vertices(const ConformingSection& section) {
  std::vector<Point2> result;
  const auto& triangles = section.triangulation.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (section.internal[TriangleId(t)] != 0) continue;
    const PlaneTriangleVertices& v = triangles[TriangleId(t)];
    const Point2 p = circumcentre(section.point(v[0]), section.point(v[1]), section.point(v[2]));
    if (std::isfinite(p.x) && std::isfinite(p.y)) result.push_back(p);
  }
  return result;
}

std::vector<Point2> projected_into(const ConformingSection& section,
                                   std::span<const Point2> candidates) {
  if (section.vertex_count() == 0) return {};
  const Interior interior(section);
  std::vector<Point2> sorted(candidates.begin(), candidates.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
  // Kept points by y, those that are still near in x.
  std::multimap<double, Point2> recent;
  std::vector<Point2> kept;
  std::size_t oldest = 0;
  for (const Point2& p : sorted) {
    if (!interior.is_well_inside(p)) continue;
    for (; oldest < kept.size() && kept[oldest].x < p.x - interior.near(); ++oldest) {
      auto at = recent.lower_bound(kept[oldest].y);
      while (at->second != kept[oldest]) ++at;
      recent.erase(at);
    }
    const auto last = recent.upper_bound(p.y + interior.near());
    if (std::any_of(recent.lower_bound(p.y - interior.near()), last, [&](const auto& other) {
          return std::hypot(other.second.x - p.x, other.second.y - p.y) < interior.near();
        })) {
      continue;
    }
    kept.push_back(p);
    recent.emplace(p.y, p);
  }
  return kept;
}

}  // namespace tetloft::internal::geiger
