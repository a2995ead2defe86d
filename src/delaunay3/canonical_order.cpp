#include "delaunay3/canonical_order.hpp"

#include <cstddef>

#include "spatial/sort_by_key.hpp"

namespace tetloft::internal::delaunay3_detail {

namespace {

using Coordinate = double Point3::*;

/// Most significant first.
constexpr Coordinate kSignificance[] = {&Point3::z, &Point3::x, &Point3::y};

/// Sorts points that agree in all coordinates before `coordinate`.
void sort_from(std::size_t coordinate, std::span<const Point3> points, std::span<Keyed> run) {
  for (Keyed& entry : run) entry.key = key_of(points[entry.place].*kSignificance[coordinate]);
  sort_by_key(run);
  if (coordinate + 1 == std::size(kSignificance)) return;
  for (std::size_t begin = 0, end = 0; begin < run.size(); begin = end) {
    while (end < run.size() && run[end].key == run[begin].key) ++end;
    if (end - begin > 1) sort_from(coordinate + 1, points, run.subspan(begin, end - begin));
  }
}

}  // namespace

std::vector<std::uint32_t> canonical_order(std::span<const Point3> points) {
  std::vector<Keyed> entries(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) entries[i] = {0, i};
  sort_from(0, points, entries);
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].place;
  return order;
}

}  // namespace tetloft::internal::delaunay3_detail
