#include "sections/inner_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <tetloft/delaunay2.hpp>

#include "core/guard.hpp"

namespace tetloft::internal::sections {

namespace {

struct Incircle {
  Point2 centre;
  double radius = 0;
};

double length(const Point2& p, const Point2& q) {
  const double x = q.x - p.x;
  const double y = q.y - p.y;
  return std::sqrt(x * x + y * y);
}

Incircle incircle(const std::array<Point2, 3>& p) {
  const double a = length(p[1], p[2]);
  const double b = length(p[2], p[0]);
  const double c = length(p[0], p[1]);
  const double around = a + b + c;
  if (!(around > 0)) return {p[0], 0};
  const double twice =
      std::abs((p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x));
  return {{(a * p[0].x + b * p[1].x + c * p[2].x) / around,
           (a * p[0].y + b * p[1].y + c * p[2].y) / around},
          twice / around};
}

}  // namespace

std::optional<Point2> inner_point(const FaceOverlay& overlay, FaceId face) {
  std::vector<Point2> points = overlay.border_points(face);
  std::sort(points.begin(), points.end(),
            [](const Point2& p, const Point2& q) { return canonical_less(p, q); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return std::nullopt;
  const Result<Triangulation2> triangulation = delaunay2(points);
  if (!accepted(triangulation)) return std::nullopt;
  std::vector<Incircle> circles;
  for (const PlaneTriangleVertices& t : triangulation->triangles) {
    circles.push_back(incircle(
        {triangulation->points[t[0]], triangulation->points[t[1]], triangulation->points[t[2]]}));
  }
  std::stable_sort(circles.begin(), circles.end(), [](const Incircle& a, const Incircle& b) {
    return a.radius != b.radius ? a.radius > b.radius : canonical_less(a.centre, b.centre);
  });
  for (const Incircle& circle : circles) {
    if (circle.radius > 0 && overlay.locate(circle.centre) == face) return circle.centre;
  }
  return std::nullopt;
}

}  // namespace tetloft::internal::sections
