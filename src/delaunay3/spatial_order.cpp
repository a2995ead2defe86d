#include "delaunay3/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/parallel.hpp"
#include "core/prng.hpp"
#include "delaunay3/shared_sort.hpp"
#include "delaunay3/stretches.hpp"
#include "spatial/hilbert.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

// A sort key is the round (4 bits) above the Hilbert index (20 bits for each axis).
constexpr int kAxisBits = 20;
constexpr int kHilbertBits = 3 * kAxisBits;
// 8^15 exceeds any number of points, so round 0 needs no special case.
constexpr std::uint64_t kLastRound = 15;
// Points of one cell, up to so many, stay in canonical order: the walks between them are
// short anyway.
constexpr std::size_t kSmallRun = 8;
constexpr std::size_t kPointsOfCurve = std::size_t{1} << 14;
constexpr std::uint64_t kSeed = 0x7E71'0F73'D000'0003ULL;

std::uint64_t draw_round(Prng& prng) {
  std::uint64_t draw = prng.next();
  std::uint64_t round = kLastRound;
  for (; round > 0 && draw % kRoundRatio == 0; --round) draw /= kRoundRatio;
  return round;
}

// Maps points to the cells of a grid over the bounding cube of some of them.
class Grid {
 public:
  // Leaves z out if `flat`.
  Grid(std::span<const Point3> points, std::span<const Keyed> some, bool flat)
      : z_weight_(flat ? 0 : 0.5) {
    low_ = halved(points[some.front().place]);
    std::array<double, 3> high = low_;
    for (const Keyed& entry : some) {
      const std::array<double, 3> p = halved(points[entry.place]);
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) extent_ = std::max(extent_, high[k] - low_[k]);
  }

  // Zero where the points differ in z left out only, or by halves of the least double.
  [[nodiscard]] double extent() const { return extent_; }

  // Requires a positive extent.
  [[nodiscard]] std::uint64_t hilbert(const Point3& point) const {
    constexpr double kLastCell = (std::uint64_t{1} << kAxisBits) - 1;
    const std::array<double, 3> p = halved(point);
    std::array<std::uint32_t, 3> cell;
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = static_cast<std::uint32_t>((p[k] - low_[k]) / extent_ * kLastCell);
    }
    return hilbert_index<3>(cell, kAxisBits);
  }

 private:
  // Halved, so that no difference of two coordinates overflows.
  [[nodiscard]] std::array<double, 3> halved(const Point3& p) const {
    return {0.5 * p.x, 0.5 * p.y, z_weight_ * p.z};
  }

  double z_weight_;
  std::array<double, 3> low_;
  double extent_ = 0;
};

// Replaces the Hilbert index in the keys of `run` by that in the run's own bounding cube,
// and sorts it. False where the cube has no extent.
bool sort_along_curve(std::span<const Point3> points, std::span<Keyed> run, bool flat,
                      unsigned threads) {
  const Grid grid(points, run, flat);
  if (grid.extent() == 0) return false;
  const Stretches all = Stretches::of(run.size(), kPointsOfCurve, run.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (Keyed& entry : run.subspan(all.begin(k), all.end(k) - all.begin(k))) {
      entry.key = (entry.key >> kHilbertBits << kHilbertBits) | grid.hilbert(points[entry.place]);
    }
  });
  sort_by_key_shared(run, threads);
  return true;
}

// Runs of points that are still to be sorted along the curve: those of equal keys. Points that
// share a cell, as in dense clusters or in planes far from each other, get a finer grid: it spans
// their own bounding cube, so it separates at least two of them.
std::vector<std::span<Keyed>> runs_of_cells(std::span<Keyed> run) {
  return equal_runs(run, kSmallRun + 1);
}

// Sorts a run and, on one thread, all runs within.
void sort_nested(std::span<const Point3> points, std::span<Keyed> run, bool flat) {
  std::vector<std::span<Keyed>> runs{run};
  while (!runs.empty()) {
    const std::span<Keyed> next = runs.back();
    runs.pop_back();
    if (!sort_along_curve(points, next, flat, 1)) continue;
    const std::vector<std::span<Keyed>> within = runs_of_cells(next);
    runs.insert(runs.end(), within.begin(), within.end());
  }
}

// Whether at most two values of z occur. Then z is left out of the order: the Delaunay
// triangulation of two parallel planes does not depend on their distance, and points of
// the two are neighbours where they are near each other in projection.
bool on_two_planes(std::span<const Point3> points) {
  if (points.empty()) return true;
  const double low = points.front().z;
  const double high = points.back().z;
  const auto above = std::partition_point(points.begin(), points.end(),
                                          [&](const Point3& p) { return p.z == low; });
  return above == points.end() || above->z == high;
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const Point3> points, unsigned threads) {
  std::vector<std::uint32_t> order(points.size());
  if (points.empty()) return order;
  const bool flat = on_two_planes(points);
  std::vector<Keyed> keyed(points.size());
  Prng prng(kSeed);
  for (std::size_t i = 0; i < points.size(); ++i) {
    keyed[i] = {draw_round(prng) << kHilbertBits, static_cast<std::uint32_t>(i)};
  }
  if (sort_along_curve(points, keyed, flat, threads)) {
    const std::vector<std::span<Keyed>> runs = runs_of_cells(keyed);
    parallel_for(runs.size(), threads, [&](std::size_t k) { sort_nested(points, runs[k], flat); });
  }
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keyed[i].place;
  return order;
}

}  // namespace tetloft::internal::delaunay3_detail
