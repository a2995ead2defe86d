// Natural neighbours of many points at once, in space and in the plane.
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

/// Of the points first to last, what NaturalNeighboursOfMany has of all; begin without its 0.
template <class Point, class Location, class NeighboursAt>
[[nodiscard]] NaturalNeighboursOfMany natural_of_stretch(const std::vector<Location>& locations,
                                                         std::span<const Point> points,
                                                         std::size_t first, std::size_t last,
                                                         const NeighboursAt& neighbours_at) {
  NaturalNeighboursOfMany found;
  for (std::size_t i = first; i < last; ++i) {
    if (locations[i].kind != LocationKind::outside) {
      const Result<NaturalNeighbours> of = neighbours_at(locations[i], points[i]);
      if (!of) throw Failed(of.error());
      found.vertices.insert(found.vertices.end(), of->vertices.begin(), of->vertices.end());
      found.weights.insert(found.weights.end(), of->weights.begin(), of->weights.end());
    }
    found.begin.push_back(found.vertices.size());
  }
  return found;
}

[[nodiscard]] inline NaturalNeighboursOfMany joined(std::vector<NaturalNeighboursOfMany> parts) {
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

/// neighbours_at(location, point), a Result, is asked of points that are not outside. Locations are
/// found along a curve, each from the one before; from there on each point is by itself. Throws
/// Failed where one is refused.
template <class Triangulation, class Point, class NeighboursAt>
[[nodiscard]] NaturalNeighboursOfMany natural_of_many(const Triangulation& triangulation,
                                                      std::span<const Point> points,
                                                      const Execution& execution,
                                                      const NeighboursAt& neighbours_at) {
  constexpr std::size_t kStretch = 256;
  const std::size_t stretches = (points.size() + kStretch - 1) / kStretch;
  WatchedWork work(execution, stretches + 1);
  work.go_on();
  const auto locations = triangulation.locate(points, untold(execution));
  if (!locations) throw Failed(locations.error());
  work.step_done_go_on();
  std::vector<NaturalNeighboursOfMany> parts(stretches);
  parallel_for(stretches, execution.threads, [&](std::size_t k) {
    parts[k] = natural_of_stretch(*locations, points, k * kStretch,
                                  std::min(points.size(), (k + 1) * kStretch), neighbours_at);
    work.step_done_go_on();
  });
  return joined(std::move(parts));
}

/// Where the vertices span too little, of so many points.
[[nodiscard]] inline NaturalNeighboursOfMany natural_of_none(std::size_t points) {
  NaturalNeighboursOfMany none;
  none.begin.assign(points + 1, 0);
  return none;
}

}  // namespace tetloft::internal::voronoi
