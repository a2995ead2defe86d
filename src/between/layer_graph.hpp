// What hangs together through the layers of a slab: solids or voids of one class, layer by layer,
// and which of neighbouring layers share samples when the motion brings them to one height.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "between/class_shape.hpp"
#include "between/layer_labels.hpp"

namespace tetloft::internal::between {

/// Nodes below and above.
using LayerEdge = std::pair<std::uint32_t, std::uint32_t>;

enum class NodeKind { solid, empty };

struct LayerGraph {
  NodeKind kind = NodeKind::solid;
  std::vector<LayerLabels> layers;
  std::vector<std::vector<LayerEdge>> edges;  ///< edges[k]: between layers k and k + 1, sorted
};

/// By layer and node: numbers that are equal iff the nodes are connected. The exteriors of all
/// layers are one.
using NodeNumbers = std::vector<std::vector<std::size_t>>;

/// Nodes of neighbouring layers are joined where they share samples when both are moved to the
/// middle between them: solids at least one and 2 % of the smaller, voids above 10 % of the
/// smaller. Where a node would have no edge on a side, they are compared as they lie. `at` as in
/// interpolate().
[[nodiscard]] LayerGraph connect_layers(NodeKind kind, const ClassShape& shape,
                                        const std::vector<double>& at,
                                        std::vector<LayerLabels> layers);

/// Connected at all; through a node's layer and those below; through its layer and those above.
[[nodiscard]] NodeNumbers connected(const LayerGraph& graph);
[[nodiscard]] NodeNumbers connected_below(const LayerGraph& graph);
[[nodiscard]] NodeNumbers connected_above(const LayerGraph& graph);

/// The nodes of a layer between, without the exterior, that are connected both below and above:
/// groups of two or more, of one where it is with the exterior (`with_exterior`).
struct DoublyConnected {
  std::vector<std::uint32_t> nodes;  // ascending
  bool with_exterior = false;
};
[[nodiscard]] std::vector<DoublyConnected> doubly_connected(const LayerGraph& graph,
                                                            const NodeNumbers& below,
                                                            const NodeNumbers& above,
                                                            std::size_t layer);

}  // namespace tetloft::internal::between
