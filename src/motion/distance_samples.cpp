#include "motion/distance_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::internal {

namespace {

// An edge, its ends in canonical order.
struct Edge {
  Point2 a, b;
};

template <class Visit>
void visit_edges(std::span<const Contour* const> contours, const Visit& visit) {
  for (const Contour* contour : contours) {
    const std::vector<Point2>& v = contour->vertices;
    Point2 last = v.back();
    for (const Point2& p : v) {
      visit(canonical_less(last, p) ? Edge{last, p} : Edge{p, last});
      last = p;
    }
  }
}

// The least index in [0, n] whose place is at least `at`, for places (index · step).
std::size_t first_index(double at, double step, std::size_t n) {
  const double k = std::ceil(at / step);
  if (!(k > 0)) return 0;
  return k < static_cast<double>(n) ? static_cast<std::size_t>(k) : n;
}

// One coordinate range of samples within `reach` of [low, high], both from the origin.
struct Range {
  std::size_t first, end;
};
Range range_of(double low, double high, double reach, double step, std::size_t n) {
  return {first_index(low - reach, step, n), first_index(high + reach, step, n)};
}

// Lowers the squared distances of the samples around the edge.
void measure(const Edge& edge, const LatticeWindow& w, double limit, std::vector<double>& squared) {
  const Point2 a{edge.a.x - w.origin.x, edge.a.y - w.origin.y};
  const Point2 b{edge.b.x - w.origin.x, edge.b.y - w.origin.y};
  const Range columns = range_of(a.x, b.x, limit, w.step, w.nx);
  const Range rows = range_of(std::min(a.y, b.y), std::max(a.y, b.y), limit, w.step, w.ny);
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length2 = dx * dx + dy * dy;
  const double inverse = 1 / length2;
  for (std::size_t j = rows.first; j < rows.end; ++j) {
    const double py = static_cast<double>(j) * w.step - a.y;
    double* const row = squared.data() + j * w.nx;
    for (std::size_t i = columns.first; i < columns.end; ++i) {
      const double px = static_cast<double>(i) * w.step - a.x;
      double t = (px * dx + py * dy) * inverse;
      t = t < 0 ? 0 : t;
      t = t > 1 ? 1 : t;
      const double ex = px - t * dx;
      const double ey = py - t * dy;
      const double d = ex * ex + ey * ey;
      row[i] = d < row[i] ? d : row[i];
    }
  }
}

// Where an edge passes the rows, all samples from there on change sides.
void cross(const Edge& edge, const LatticeWindow& w, std::vector<std::uint8_t>& crossed) {
  const bool up = edge.a.y < edge.b.y;
  const Point2& low = up ? edge.a : edge.b;
  const Point2& high = up ? edge.b : edge.a;
  const double y0 = low.y - w.origin.y;
  const double y1 = high.y - w.origin.y;
  const std::size_t end = first_index(y1, w.step, w.ny);
  for (std::size_t j = first_index(y0, w.step, w.ny); j < end; ++j) {
    const double t = (static_cast<double>(j) * w.step - y0) / (y1 - y0);
    const double x = low.x - w.origin.x + t * (high.x - low.x);
    const std::size_t i = first_index(x, w.step, w.nx);
    if (i < w.nx) crossed[j * w.nx + i] ^= 1U;
  }
}

}  // namespace

std::vector<double> signed_distances(std::span<const Contour* const> contours,
                                     const LatticeWindow& window, double limit) {
  std::vector<double> result(window.size(), limit * limit);
  std::vector<std::uint8_t> crossed(window.size(), 0);
  visit_edges(contours, [&](const Edge& edge) {
    measure(edge, window, limit, result);
    cross(edge, window, crossed);
  });
  for (std::size_t j = 0; j < window.ny; ++j) {
    std::uint8_t inside = 0;
    for (std::size_t i = 0; i < window.nx; ++i) {
      const std::size_t k = j * window.nx + i;
      inside ^= crossed[k];
      const double d = std::sqrt(result[k]);
      result[k] = inside != 0 ? -d : d;
    }
  }
  return result;
}

}  // namespace tetloft::internal
