// Many points at once: in which order, and the tets as the engine holds them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/point.hpp>

#include "core/parallel.hpp"
#include "delaunay3/growing_tets.hpp"
#include "delaunay3/stretches.hpp"

namespace tetloft::internal::delaunay3_detail {

/// items[places[0]], items[places[1]], …
template <class T, class Items>
[[nodiscard]] std::vector<T> picked(const Items& items, std::span<const std::uint32_t> places,
                                    unsigned threads) {
  constexpr std::size_t kPicked = std::size_t{1} << 15;
  std::vector<T> result(places.size());
  const Stretches all = Stretches::of(places.size(), kPicked, places.size());
  parallel_for(all.count, threads, [&](std::size_t k) {
    for (std::size_t i = all.begin(k); i < all.end(k); ++i) result[i] = items[places[i]];
  });
  return result;
}

/// An order of insertion.
struct BatchOrder {
  /// Of the affine hull.
  int dimension = -1;
  /// The places of all points in order, first `dimension` + 1 that are affinely independent.
  std::vector<std::uint32_t> places;
};

/// Requires distinct finite points in canonical order.
[[nodiscard]] BatchOrder batch_order(std::span<const Point3> points, unsigned threads);

/// The tets of distinct finite points that span space, by the incremental engine: vertices are the
/// places of points, vertex 0 of ghost tets is kGhost, and invalid in slots without a tet. Throws
/// std::length_error where they would be 2^30 or more.
[[nodiscard]] OwnedSlots batch_tets(std::vector<Point3> points, const Execution& execution);

}  // namespace tetloft::internal::delaunay3_detail
