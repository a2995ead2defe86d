// Natural neighbours of many points, in space and in the plane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <tetloft/execution.hpp>
#include <tetloft/location_kind.hpp>
#include <tetloft/result.hpp>
#include <tetloft/voronoi.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal::voronoi {

/// One after the other, in their order.
[[nodiscard]] inline NaturalNeighboursOfMany joined_neighbours(
    std::vector<NaturalNeighboursOfMany> parts) {
  NaturalNeighboursOfMany all;
  all.begin.push_back(0);
  for (NaturalNeighboursOfMany& part : parts) {
    const std::size_t before = all.vertices.size();
    for (const std::size_t end : part.begin) all.begin.push_back(before + end);
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    all.weights.insert(all.weights.end(), part.weights.begin(), part.weights.end());
    part = {};
  }
  return all;
}

/// Of each point that is not outside what one(location, point), a Result, gives. Locations are
/// found along a curve, each from the one before; from there on each point is by itself.
template <class Triangulation, class Point, class One>
[[nodiscard]] Result<NaturalNeighboursOfMany> neighbours_of_each(const Triangulation& triangulation,
                                                                 std::span<const Point> points,
                                                                 const Execution& execution,
                                                                 const One& one) {
  constexpr std::size_t kStretch = 256;
  const std::size_t stretches = (points.size() + kStretch - 1) / kStretch;
  WatchedWork work(execution, stretches + 1);
  work.go_on();
  const auto locations = triangulation.locate(points, untold(execution));
  if (!locations) return locations.error();
  work.step_done_go_on();
  std::vector<NaturalNeighboursOfMany> parts(stretches);
  parallel_for(stretches, execution.threads, [&](std::size_t k) {
    NaturalNeighboursOfMany& found = parts[k];  // begin without its 0
    const std::size_t end = std::min(points.size(), (k + 1) * kStretch);
    for (std::size_t i = k * kStretch; i < end; ++i) {
      if ((*locations)[i].kind != LocationKind::outside) {
        const Result<NaturalNeighbours> of = one((*locations)[i], points[i]);
        if (!of) throw Failed(of.error());
        found.vertices.insert(found.vertices.end(), of->vertices.begin(), of->vertices.end());
        found.weights.insert(found.weights.end(), of->weights.begin(), of->weights.end());
      }
      found.begin.push_back(found.vertices.size());
    }
    work.step_done_go_on();
  });
  return joined_neighbours(std::move(parts));
}

/// Of so many points without any.
[[nodiscard]] inline NaturalNeighboursOfMany no_neighbours(std::size_t points) {
  NaturalNeighboursOfMany none;
  none.begin.assign(points + 1, 0);
  return none;
}

}  // namespace tetloft::internal::voronoi
