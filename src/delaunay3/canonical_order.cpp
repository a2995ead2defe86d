// See canonical_order.hpp.
#include "delaunay3/canonical_order.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <tetloft/predicates.hpp>

#include "core/parallel.hpp"
#include "delaunay3/shared_sort.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

using Coordinate = double Point3::*;

/// Most significant first.
constexpr Coordinate kSignificance[] = {&Point3::z, &Point3::x, &Point3::y};

constexpr std::size_t kPointsOfKeying = std::size_t{1} << 15;

void key_by(std::size_t coordinate, std::span<const Point3> points, std::span<Keyed> run) {
  for (Keyed& entry : run) entry.key = key_of(points[entry.place].*kSignificance[coordinate]);
}

/// Sorts points that agree in all coordinates before `coordinate`.
void sort_from(std::size_t coordinate, std::span<const Point3> points, std::span<Keyed> run) {
  key_by(coordinate, points, run);
  sort_by_key(run);
  if (coordinate + 1 == std::size(kSignificance)) return;
  for (const std::span<Keyed> equal : equal_runs(run)) sort_from(coordinate + 1, points, equal);
}

bool is_sorted(std::span<const Point3> points) {
  return std::is_sorted(points.begin(), points.end(),
                        [](const Point3& a, const Point3& b) { return canonical_less(a, b); });
}

}  // namespace

std::vector<std::uint32_t> canonical_order(std::span<const Point3> points, unsigned threads) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  if (is_sorted(points)) return order;
  std::vector<Keyed> entries(points.size());
  const Stretches all = Stretches::of(points.size(), kPointsOfKeying, points.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) {
      entries[i] = {key_of(points[i].z), static_cast<std::uint32_t>(i)};
    }
  });
  sort_by_key_shared(entries, threads);
  const std::vector<std::span<Keyed>> planes = equal_runs(entries);
  parallel_for(planes.size(), threads, [&](std::size_t k) { sort_from(1, points, planes[k]); });
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) order[i] = entries[i].place;
  });
  return order;
}

}  // namespace tetloft::internal::delaunay3_detail
