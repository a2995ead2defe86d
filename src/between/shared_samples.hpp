// What nodes of neighbouring layers share when both layers are moved to one height.
#pragma once

#include <cstddef>
#include <vector>

#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

/// How many samples two nodes have in common.
struct SharedSamples {
  LayerEdge nodes;
  std::size_t samples = 0;
};

/// Two neighbouring layers of one class.
struct LayerPair {
  NodeKind kind;
  const LayerLabels& below;
  const LayerLabels& above;
  const ClassShape& shape;
  double longest;  ///< no motion of the shape is longer along an axis

  /// Is it enough to be connected?
  [[nodiscard]] bool is_edge(const SharedSamples& shared) const;
};

/// Of each two nodes that have some, with both layers moved by this share of the motion towards
/// each other; sorted. Where it does not matter for is_edge() there may be more than are told.
[[nodiscard]] std::vector<SharedSamples> shared_samples(const LayerPair& pair, double share);

}  // namespace tetloft::internal::between
