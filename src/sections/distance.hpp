// How far two regions lie apart, of which the edges are in trees already.
#pragma once

#include <cstddef>
#include <optional>

#include "sections/contour_edges.hpp"

namespace tetloft::internal::sections {

struct Apart {
  std::optional<double> distance;  ///< as of region_distance_within()
  std::size_t pairs = 0;           ///< how many pairs of edges were measured
};

/// region_distance_within() of two regions, each made of its outline. Apart from building the trees
/// this is all: one region against many costs its tree once.
[[nodiscard]] Apart measure(const ContourEdges& a, const ContourEdges& b, double limit);

}  // namespace tetloft::internal::sections
