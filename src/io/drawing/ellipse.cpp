// Quarter by quarter by the rational parametrization, so that no sine is needed.
#include "io/drawing/ellipse.hpp"

namespace tetloft::internal::io {

std::vector<Point2> ellipse_points(const Point2& centre, double rx, double ry) {
  constexpr std::size_t kPerQuarter = kEllipsePoints / 4;
  std::vector<Point2> points;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (std::size_t i = 0; i < kPerQuarter; ++i) {
      const double t = static_cast<double>(i) / kPerQuarter;
      double x = (1 - t * t) / (1 + t * t);
      double y = 2 * t / (1 + t * t);
      for (int turn = 0; turn < quarter; ++turn) {
        const double before = x;
        x = -y;
        y = before;
      }
      points.push_back({centre.x + rx * x, centre.y + ry * y});
    }
  }
  return points;
}

}  // namespace tetloft::internal::io
