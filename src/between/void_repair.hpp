// Voids of a class that open and close within a slab are filled, or opened to their neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "between/class_shape.hpp"
#include "between/competition.hpp"
#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

/// The voids of a class in all layers, and how they are connected.
struct VoidGraph {
  LayerGraph graph;
  NodeNumbers all, below, above;
};

[[nodiscard]] VoidGraph graph_of_voids(const ClassShape& shape, const std::vector<double>& at,
                                       std::vector<LayerLabels> layers);

/// Of voids in one layer between that are connected below and above, the exterior or the deepest
/// stays. Every other one, and every one that is connected to neither the exterior nor a hole of a
/// given layer, is opened to its nearest neighbour (one of the same group, for the latter any of
/// the others) if the wall between is thinner than the void is deep, else filled; never if it holds
/// foreign samples. False if nothing changed.
bool repair_voids(const VoidGraph& voids, ForeignSamples& foreign, std::size_t layer,
                  ClassShape& shape);

}  // namespace tetloft::internal::between
