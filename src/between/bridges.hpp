// Parts of a class that the layers between do not connect are joined through them: what its regions
// tell is then that they are one, but not where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "between/class_shape.hpp"
#include "between/competition.hpp"
#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

/// A sample at which something inside in layer `below` is connected with the layer above that.
struct LayerTie {
  std::size_t below;
  std::uint32_t place;
};

/// Joins the connected sets of the graph by cheapest paths within layers between, and from any
/// layer to the next one at the same sample: a step costs 0.1 and the square of how far outside the
/// sample is, none leads over foreign samples. Paths become inside, as thick as the lattice tells.
/// The ties are where they go from layer to layer.
[[nodiscard]] std::vector<LayerTie> bridge_parts(const LayerGraph& solids, ForeignSamples& foreign,
                                                 ClassShape& shape);

}  // namespace tetloft::internal::between
