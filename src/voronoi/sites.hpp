// Sites of cells: which are refused, and all of a triangulation at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>
#include <tetloft/execution.hpp>
#include <tetloft/result.hpp>

#include "core/guard.hpp"
#include "core/parallel.hpp"
#include "core/watched_work.hpp"

namespace tetloft::internal::voronoi {

[[nodiscard]] inline Error immoderate_site(DelaunayVertex v) {
  Error error{ErrorCode::invalid_input, "a coordinate is beyond 2^300", {}};
  error.where.vertex = v.index;
  return error;
}

/// The cells of all vertices, by index, each by make(vertex), which gives a Result: `stretch` of
/// them at a time by several threads. Throws Failed where one is refused.
template <class Triangulation, class Make>
[[nodiscard]] auto all_cells(const Triangulation& triangulation, std::size_t stretch,
                             const Execution& execution, const Make& make) {
  using Cell = std::decay_t<decltype(*make(DelaunayVertex()))>;
  const auto live = triangulation.vertices();
  const std::vector<DelaunayVertex> sites(live.begin(), live.end());
  const std::size_t stretches = (sites.size() + stretch - 1) / stretch;
  std::vector<Cell> cells(sites.size());
  WatchedWork work(execution, stretches);
  work.go_on();
  parallel_for(stretches, execution.threads, [&](std::size_t k) {
    const std::size_t end = std::min(sites.size(), (k + 1) * stretch);
    for (std::size_t i = k * stretch; i < end; ++i) {
      Result<Cell> cell = make(sites[i]);
      if (!cell) throw Failed(cell.error());
      cells[i] = *std::move(cell);
    }
    work.step_done_go_on();
  });
  return cells;
}

}  // namespace tetloft::internal::voronoi
