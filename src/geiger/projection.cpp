#include "geiger/projection.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <tetloft/predicates.hpp>

namespace tetloft::internal::geiger {

namespace {

constexpr double kNear = 0.1;

double distance_to_segment(const Point2& p, const Point2& a, const Point2& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  const double s = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - a.x - s * dx, p.y - a.y - s * dy);
}

// The contour edges of a section in rows of equal height, each edge in all rows it crosses.
class EdgeRows {
 public:
  explicit EdgeRows(const ConformingSection& section) : section_(section) {
    double sum = 0;
    std::size_t edges = 0;
    low_ = high_ = section.point(PlaneVertexId(0)).y;
    for_each_edge([&](const Point2& a, const Point2& b) {
      sum += std::hypot(b.x - a.x, b.y - a.y);
      ++edges;
      low_ = std::min(low_, a.y);
      high_ = std::max(high_, a.y);
    });
    near_ = kNear * sum / static_cast<double>(edges);
    const double rows = std::min((high_ - low_) / near_, static_cast<double>(edges));
    row_.resize(static_cast<std::size_t>(std::max(1.0, rows)));
    for_each_edge([&](const Point2& a, const Point2& b) {
      const std::size_t last = row_of(std::max(a.y, b.y));
      for (std::size_t r = row_of(std::min(a.y, b.y)); r <= last; ++r) row_[r].push_back({a, b});
    });
  }

  [[nodiscard]] double near() const { return near_; }

  [[nodiscard]] bool is_well_inside(const Point2& p) const {
    if (!(p.y > low_ && p.y < high_)) return false;
    bool inside = false;
    for (const auto& [a, b] : row_[row_of(p.y)]) {
      const Point2& below = a.y <= b.y ? a : b;
      const Point2& above = a.y <= b.y ? b : a;
      if (!(below.y <= p.y && p.y < above.y)) continue;
      if (orient2d(below, above, p) == Sign::positive) inside = !inside;
    }
    if (!inside) return false;
    const std::size_t last = row_of(p.y + near_);
    for (std::size_t r = row_of(p.y - near_); r <= last; ++r) {
      for (const auto& [a, b] : row_[r]) {
        if (distance_to_segment(p, a, b) < near_) return false;
      }
    }
    return true;
  }

 private:
  struct Edge {
    Point2 a, b;
  };

  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t v = 0; v < section_.vertex_count(); ++v) {
      const PlaneVertexId next = section_.next[PlaneVertexId(v)];
      if (next.valid()) visit(section_.point(PlaneVertexId(v)), section_.point(next));
    }
  }

  [[nodiscard]] std::size_t row_of(double y) const {
    const double at = (y - low_) / (high_ - low_) * static_cast<double>(row_.size());
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(row_.size() - 1)));
  }

  const ConformingSection& section_;
  double low_ = 0;
  double high_ = 0;
  double near_ = 0;
  std::vector<std::vector<Edge>> row_;
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
  const EdgeRows rows(section);
  std::vector<Point2> sorted(candidates.begin(), candidates.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
  // Kept points by y, those that are still near in x.
  std::multimap<double, Point2> recent;
  std::vector<Point2> kept;
  std::size_t oldest = 0;
  for (const Point2& p : sorted) {
    if (!rows.is_well_inside(p)) continue;
    for (; oldest < kept.size() && kept[oldest].x < p.x - rows.near(); ++oldest) {
      auto at = recent.lower_bound(kept[oldest].y);
      while (at->second != kept[oldest]) ++at;
      recent.erase(at);
    }
    const auto last = recent.upper_bound(p.y + rows.near());
    if (std::any_of(recent.lower_bound(p.y - rows.near()), last, [&](const auto& other) {
          return std::hypot(other.second.x - p.x, other.second.y - p.y) < rows.near();
        })) {
      continue;
    }
    kept.push_back(p);
    recent.emplace(p.y, p);
  }
  return kept;
}

}  // namespace tetloft::internal::geiger
