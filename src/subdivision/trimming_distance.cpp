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

RegionDistance::RegionDistance(const ConformingSection& section) : contours_(section) {
  for (const auto& edge : contours_.edges()) largest_ = std::max(largest_, magnitude(edge.a));
}

/// More than distances are off by rounding: some ten roundings
/// of numbers up to twice the largest coordinates.
double RegionDistance::tolerance(const Point2& p) const {
  return 0x1p-44 * std::max(largest_, magnitude(p));
}

bool RegionDistance::contains(const Point2& p) const {
  return contours_.locate(p) != sections::ContourEdges::Where::outside;
}

double RegionDistance::distance(const Point2& p, double enough) const {
  double best = std::numeric_limits<double>::infinity();
  const double tolerated = tolerance(p);
  contours_.tree().query_nearest(
      p,
      [&](std::size_t e) {
        const auto& [a, b] = contours_.edges()[e];
        best = std::min(best, distance_to_edge(p, a, b));
      },
      [&] { return best <= enough ? -1.0 : best + tolerated; });
  return best;
}

}  // namespace tetloft::internal
