#include "motion/distance_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::internal {

namespace {

using Edge = LatticeEdges::Edge;

// The least index of [low, high] that is at least `at`.
std::int64_t first_index(double at, std::int64_t low, std::int64_t high) {
  const double k = std::ceil(at);
  if (!(k > static_cast<double>(low))) return low;
  return k < static_cast<double>(high) ? static_cast<std::int64_t>(k) : high;
}

// Lowers the squared distances of the samples around the edge.
void measure(const Edge& e, const LatticeWindow& w, double limit, std::vector<double>& squared) {
  const std::int64_t i0 = first_index(e.a.x - limit, w.i0, w.i1);
  const std::int64_t i1 = first_index(e.b.x + limit, w.i0, w.i1);
  const std::int64_t j0 = first_index(std::min(e.a.y, e.b.y) - limit, w.j0, w.j1);
  const std::int64_t j1 = first_index(std::max(e.a.y, e.b.y) + limit, w.j0, w.j1);
  const double dx = e.b.x - e.a.x;
  const double dy = e.b.y - e.a.y;
  const double inverse = 1 / (dx * dx + dy * dy);
  const double x0 = static_cast<double>(i0) - e.a.x;
  for (std::int64_t j = j0; j < j1; ++j) {
    const double py = static_cast<double>(j) - e.a.y;
    double* const row = squared.data() + static_cast<std::size_t>(j - w.j0) * w.nx() + (i0 - w.i0);
    const int n = static_cast<int>(i1 - i0);
    for (int i = 0; i < n; ++i) {
      const double px = x0 + static_cast<double>(i);
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
void cross(const Edge& e, const LatticeWindow& w, std::vector<std::uint8_t>& crossed) {
  const bool up = e.a.y < e.b.y;
  const Point2& low = up ? e.a : e.b;
  const Point2& high = up ? e.b : e.a;
  const std::int64_t end = first_index(high.y, w.j0, w.j1);
  for (std::int64_t j = first_index(low.y, w.j0, w.j1); j < end; ++j) {
    const double t = (static_cast<double>(j) - low.y) / (high.y - low.y);
    const std::int64_t i = first_index(low.x + t * (high.x - low.x), w.i0, w.i1);
    if (i < w.i1) {
      crossed[static_cast<std::size_t>(j - w.j0) * w.nx() + static_cast<std::size_t>(i - w.i0)] ^= 1U;
    }
  }
}

}  // namespace

LatticeEdges::LatticeEdges(const Section& section, double step) {
  for (const Contour& contour : section.contours) {
    Point2 last{contour.vertices.back().x / step, contour.vertices.back().y / step};
    for (const Point2& p : contour.vertices) {
      const Point2 next{p.x / step, p.y / step};
      box_.add(next);
      if (!(last == next)) edges_.push_back(canonical_less(last, next) ? Edge{last, next} : Edge{next, last});
      last = next;
    }
  }
}

DistanceSamples sample_distances(const LatticeEdges& edges, const LatticeWindow& window,
                                 double limit) {
  DistanceSamples result{window, std::vector<double>(window.size(), limit * limit)};
  std::vector<std::uint8_t> crossed(window.size(), 0);
  for (const Edge& e : edges.edges()) {
    measure(e, window, limit, result.value);
    cross(e, window, crossed);
  }
  std::size_t k = 0;
  for (std::size_t j = 0; j < window.ny(); ++j) {
    std::uint8_t inside = 0;
    for (std::size_t i = 0; i < window.nx(); ++i, ++k) {
      inside ^= crossed[k];
      const double d = std::sqrt(result.value[k]);
      result.value[k] = inside != 0 ? -d : d;
    }
  }
  return result;
}

}  // namespace tetloft::internal
