#include "motion/distance_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetloft::internal::motion {

namespace {

using Edge = LatticeEdges::Edge;

// Edges are looked at a little farther than distances are followed: a sample beyond that along x or
// y is farther in rounded arithmetic, too (coordinates below 2^40 have ulps of 2^-13 at most).
constexpr double kSlack = 0x1p-10;

// The least index of [low, high] that is at least `at`.
std::int64_t first_index(double at, std::int64_t low, std::int64_t high) {
  const double k = std::ceil(at);
  if (!(k > static_cast<double>(low))) return low;
  return k < static_cast<double>(high) ? static_cast<std::int64_t>(k) : high;
}

// Lowers the squared distances of the samples within `reach` of the edge.
void measure(const Edge& e, const LatticeWindow& w, double reach, std::vector<double>& squared) {
  const std::int64_t i0 = first_index(e.a.x - reach, w.i0, w.i1);
  const std::int64_t j0 = first_index(std::min(e.a.y, e.b.y) - reach, w.j0, w.j1);
  const std::int64_t j1 = first_index(std::max(e.a.y, e.b.y) + reach, w.j0, w.j1);
  const auto n = static_cast<int>(first_index(e.b.x + reach, w.i0, w.i1) - i0);
  if (n <= 0) return;
  const double dx = e.b.x - e.a.x;
  const double dy = e.b.y - e.a.y;
  const double length2 = dx * dx + dy * dy;
  const auto x0 = static_cast<double>(i0);
  for (std::int64_t j = j0; j < j1; ++j) {
    const double py = static_cast<double>(j) - e.a.y;
    double* const row = squared.data() + w.place(i0, j);
    for (int i = 0; i < n; ++i) {
      const double px = (x0 + static_cast<double>(i)) - e.a.x;
      double t = (px * dx + py * dy) / length2;
      t = t > 0 ? t : 0;
      t = t < 1 ? t : 1;
      const double ex = px - t * dx;
      const double ey = py - t * dy;
      const double d = ex * ex + ey * ey;
      row[i] = d < row[i] ? d : row[i];
    }
  }
}

// Where an edge passes the rows, all samples from there on change sides.
void pass(const Edge& e, const LatticeWindow& w, std::vector<std::uint8_t>& passed) {
  const bool up = e.a.y < e.b.y;
  const Point2& low = up ? e.a : e.b;
  const Point2& high = up ? e.b : e.a;
  const std::int64_t end = first_index(high.y, w.j0, w.j1);
  for (std::int64_t j = first_index(low.y, w.j0, w.j1); j < end; ++j) {
    const double t = (static_cast<double>(j) - low.y) / (high.y - low.y);
    const std::int64_t i = first_index(low.x + t * (high.x - low.x), w.i0, w.i1);
    if (i < w.i1) passed[w.place(i, j)] ^= 1U;
  }
}

}  // namespace

LatticeEdges::LatticeEdges(const Section& section, double step) {
  for (const Contour& contour : section.contours) add(contour, step);
}

LatticeEdges::LatticeEdges(const std::vector<const Contour*>& contours, double step) {
  for (const Contour* contour : contours) add(*contour, step);
}

void LatticeEdges::add(const Contour& contour, double step) {
  Box2 box;
  Point2 last{contour.vertices.back().x / step, contour.vertices.back().y / step};
  for (const Point2& p : contour.vertices) {
    const Point2 next{p.x / step, p.y / step};
    box.add(next);
    // Rounding may have closed an edge.
    if (canonical_less(last, next)) edges_.push_back({last, next});
    if (canonical_less(next, last)) edges_.push_back({next, last});
    last = next;
  }
  contours_.push_back({box, edges_.size()});
  box_.add(box);
}

Box2 LatticeEdges::reached_from(const LatticeWindow& w, double reach) {
  Box2 box;
  box.add(Point2{static_cast<double>(w.i0) - reach, static_cast<double>(w.j0) - reach});
  box.add(Point2{static_cast<double>(w.i1) + reach, static_cast<double>(w.j1) + reach});
  return box;
}

DistanceSamples sample_distances(const LatticeEdges& edges, const LatticeWindow& window,
                                 double farthest) {
  DistanceSamples result{window, std::vector<double>(window.size(), farthest * farthest)};
  std::vector<std::uint8_t> passed(window.size(), 0);
  edges.visit_near(window, farthest + kSlack, [&](const Edge& e) {
    measure(e, window, farthest + kSlack, result.value);
    pass(e, window, passed);
  });
  std::size_t k = 0;
  for (std::size_t j = 0; j < window.ny(); ++j) {
    std::uint8_t inside = 0;
    for (std::size_t i = 0; i < window.nx(); ++i, ++k) {
      inside ^= passed[k];
      const double d = std::sqrt(result.value[k]);
      result.value[k] = inside != 0 ? -d : d;
    }
  }
  return result;
}

}  // namespace tetloft::internal::motion
