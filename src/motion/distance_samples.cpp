#include "motion/distance_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/buckets.hpp"
#include "motion/nearest_region.hpp"
#include "motion/passed_rows.hpp"

namespace tetloft::internal::motion {

namespace {

using Edge = LatticeEdges::Edge;

// Edges are looked at a little farther than distances are followed: a sample beyond that along x or
// y is farther in rounded arithmetic, too (coordinates below 2^40 have ulps of 2^-13 at most).
constexpr double kSlack = 0x1p-10;

// The samples within `reach` of the edge along both axes.
LatticeWindow near_edge(const Edge& e, const LatticeWindow& w, double reach) {
  return {first_index(e.a.x - reach, w.i0, w.i1),
          first_index(std::min(e.a.y, e.b.y) - reach, w.j0, w.j1),
          first_index(e.b.x + reach, w.i0, w.i1),
          first_index(std::max(e.a.y, e.b.y) + reach, w.j0, w.j1)};
}

// Squared distances of samples to an edge.
class EdgeMeasure {
 public:
  explicit EdgeMeasure(const Edge& e)
      : a_(e.a), dx_(e.b.x - e.a.x), dy_(e.b.y - e.a.y), length2_(dx_ * dx_ + dy_ * dy_) {}

  /// Lowers the values of n samples of a row, from (i, j) on.
  void lower(std::int64_t i, std::int64_t j, std::int64_t n, double* squared) const {
    // Copies, which the values written are known not to be.
    const Point2 a = a_;
    const double dx = dx_;
    const double dy = dy_;
    const double length2 = length2_;
    const auto x0 = static_cast<double>(i);
    const double py = static_cast<double>(j) - a.y;
    const auto count = static_cast<int>(n);
    for (int k = 0; k < count; ++k) {
      const double px = (x0 + static_cast<double>(k)) - a.x;
      double t = (px * dx + py * dy) / length2;
      t = t > 0 ? t : 0;
      t = t < 1 ? t : 1;
      const double ex = px - t * dx;
      const double ey = py - t * dy;
      const double d = ex * ex + ey * ey;
      squared[k] = d < squared[k] ? d : squared[k];
    }
  }

 private:
  Point2 a_;
  double dx_, dy_, length2_;
};

// Distances in the making: squared, until roots are taken.
class Squares {
 public:
  Squares(DistanceSamples& samples, double farthest)
      : samples_(samples), farthest_(farthest), most_(farthest * farthest) {
    samples_.value.assign(samples_.window.size(), most_);
  }

  /// Lowers the values within `reach` of the edge.
  void measure(const Edge& e, double reach) {
    const LatticeWindow near = near_edge(e, samples_.window, reach);
    if (near.i0 >= near.i1) return;
    const EdgeMeasure measured(e);
    for (std::int64_t j = near.j0; j < near.j1; ++j) {
      measured.lower(near.i0, j, near.i1 - near.i0, squares(near.i0, j));
    }
  }

  /// The same, but for samples to which others are nearer.
  void measure_nearest(const Edge& e, double reach) {
    const LatticeWindow near = near_edge(e, samples_.window, reach);
    if (near.i0 >= near.i1 || near.j0 >= near.j1) return;
    const EdgeMeasure measured(e);
    const NearestRegion region(e, near);
    const IndexRange rows = region.rows();
    double* const first = squares(near.i0, near.j0);
    const auto nx = static_cast<std::int64_t>(samples_.window.nx());
    for (std::int64_t row = rows.first; row < rows.end; ++row) {
      const IndexRange columns = region.in_row(row);
      measured.lower(near.i0 + columns.first, near.j0 + row, columns.end - columns.first,
                     first + (row * nx + columns.first));
    }
  }

  /// Makes distances of them, and tells what tiles are near. The root of a square that was rounded
  /// is the number squared: what is farther stays so.
  void take_roots() {
    constexpr std::size_t kTile = DistanceSamples::kTile;
    const std::size_t tiles = samples_.tiles_in_row();
    samples_.near.assign(tiles * ((samples_.window.ny() + kTile - 1) / kTile), 0);
    for (std::size_t tile = 0; tile < samples_.near.size(); ++tile) {
      bool near = false;
      visit_rows(tile, [&](const double* row, std::size_t n) {
        near = near || std::any_of(row, row + n, [&](double d) { return d < most_; });
      });
      samples_.near[tile] = near ? 1 : 0;
      visit_rows(tile, [&](double* row, std::size_t n) {
        if (!near) std::fill_n(row, n, farthest_);
        for (std::size_t k = 0; near && k < n; ++k) row[k] = std::sqrt(row[k]);
      });
    }
  }

 private:
  [[nodiscard]] double* squares(std::int64_t i, std::int64_t j) {
    return samples_.value.data() + samples_.window.place(i, j);
  }

  // Calls visit(first, how many) for the rows of a tile.
  template <class Visit>
  void visit_rows(std::size_t tile, const Visit& visit) {
    constexpr std::size_t kTile = DistanceSamples::kTile;
    const std::size_t nx = samples_.window.nx();
    const std::size_t i = tile % samples_.tiles_in_row() * kTile;
    const std::size_t j = tile / samples_.tiles_in_row() * kTile;
    const std::size_t end = std::min(j + kTile, samples_.window.ny());
    for (std::size_t row = j; row < end; ++row) {
      visit(samples_.value.data() + row * nx + i, std::min(kTile, nx - i));
    }
  }

  DistanceSamples& samples_;
  double farthest_, most_;
};

// Calls visit(i, j) for the samples at distance 0, or one that vanishes in doubles.
template <class Visit>
void visit_on(const Edge& e, const LatticeWindow& w, const Visit& visit) {
  const LatticeWindow near = near_edge(e, w, kSlack);
  const EdgeMeasure measured(e);
  for (std::int64_t j = near.j0; j < near.j1; ++j) {
    for (std::int64_t i = near.i0; i < near.i1; ++i) {
      double squared = 1;
      measured.lower(i, j, 1, &squared);
      if (squared == 0) visit(i, j);
    }
  }
}

struct Sample {
  std::int64_t i, j;
};

// Samples by row.
class ByRow {
 public:
  ByRow(const std::vector<Sample>& samples, const LatticeWindow& w)
      : samples_(samples), j0_(w.j0), rows_(w.ny(), samples.size(), [&](std::size_t k) {
          return static_cast<std::size_t>(samples[k].j - w.j0);
        }) {}

  /// Ascending.
  [[nodiscard]] std::vector<std::int64_t> row(std::int64_t j) const {
    std::vector<std::int64_t> indices;
    for (const std::uint32_t k : rows_[static_cast<std::size_t>(j - j0_)]) {
      indices.push_back(samples_[k].i);
    }
    std::sort(indices.begin(), indices.end());
    return indices;
  }

 private:
  const std::vector<Sample>& samples_;
  std::int64_t j0_;
  Buckets rows_;
};

}  // namespace

LatticeEdges::LatticeEdges(const Section& section, double step) {
  for (const Contour& contour : section.contours) add(contour, step);
}

LatticeEdges::LatticeEdges(const std::vector<const Contour*>& contours, double step) {
  for (const Contour* contour : contours) add(*contour, step);
}

void LatticeEdges::add(const Contour& contour, double step) {
  Box2 box;
  std::vector<Point2> vertices;
  vertices.reserve(contour.vertices.size());
  for (const Point2& p : contour.vertices) {
    const Point2 next{p.x / step, p.y / step};
    box.add(next);
    // Rounding may have closed an edge.
    if (vertices.empty() || vertices.back() != next) vertices.push_back(next);
  }
  while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  const std::size_t n = vertices.size();
  const auto at = [&](std::size_t v) -> const Point2& { return vertices[v % n]; };
  for (std::size_t v = 0; n > 1 && v < n; ++v) {
    const Point2& p = at(v);
    const Point2& q = at(v + 1);
    const bool forward = canonical_less(p, q);
    const Point2& before = at(v + n - 1);
    const Point2& after = at(v + 2);
    edges_.push_back(forward ? Edge{p, q, before, after} : Edge{q, p, after, before});
    longest_ = std::max({longest_, std::abs(q.x - p.x), std::abs(q.y - p.y)});
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
  DistanceSamples result{window, {}, {}};
  Squares squares(result, farthest);
  std::vector<Sample> passed;
  const double reach = farthest + kSlack;
  const bool nearest = edges.longest() + reach <= NearestRegion::kLongest;
  edges.visit_near(window, reach, [&](const Edge& e) {
    if (nearest) {
      squares.measure_nearest(e, reach);
    } else {
      squares.measure(e, reach);
    }
    visit_passed(e.a, e.b, window, [&](std::int64_t i, std::int64_t j) {
      passed.push_back({i, j});
    });
  });
  squares.take_roots();
  const ByRow by_row(passed, window);
  for (std::int64_t j = window.j0; j < window.j1; ++j) {
    const std::vector<std::int64_t> turns = by_row.row(j);
    for (std::size_t k = 0; k + 1 < turns.size(); k += 2) {
      if (turns[k] == turns[k + 1]) continue;
      double* const inside = result.value.data() + window.place(turns[k], j);
      const auto n = static_cast<std::size_t>(turns[k + 1] - turns[k]);
      for (std::size_t i = 0; i < n; ++i) inside[i] = -inside[i];
    }
  }
  return result;
}

InsideSamples::InsideSamples(const LatticeEdges& edges, const LatticeWindow& window)
    : j0_(window.j0) {
  std::vector<Sample> passed;
  std::vector<Sample> on_edges;
  edges.visit_near(window, kSlack, [&](const Edge& e) {
    visit_passed(e.a, e.b, window, [&](std::int64_t i, std::int64_t j) {
      passed.push_back({i, j});
    });
    visit_on(e, window, [&](std::int64_t i, std::int64_t j) { on_edges.push_back({i, j}); });
  });
  const ByRow starts(passed, window);
  const ByRow gaps(on_edges, window);
  for (std::int64_t j = window.j0; j < window.j1; ++j) {
    begin_.push_back(runs_.size());
    const std::vector<std::int64_t> turns = starts.row(j);
    std::vector<std::int64_t> on = gaps.row(j);
    on.erase(std::unique(on.begin(), on.end()), on.end());
    auto next = on.begin();
    for (std::size_t k = 0; k + 1 < turns.size(); k += 2) {
      std::int64_t first = turns[k];
      while (next != on.end() && *next < first) ++next;
      for (; next != on.end() && *next < turns[k + 1]; ++next) {
        if (first < *next) runs_.push_back({first, *next});
        first = *next + 1;
      }
      if (first < turns[k + 1]) runs_.push_back({first, turns[k + 1]});
    }
  }
  begin_.push_back(runs_.size());
}

}  // namespace tetloft::internal::motion
