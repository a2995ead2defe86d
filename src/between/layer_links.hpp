// Which regions of neighbouring layers hang together.
#pragma once

#include <vector>

#include <tetloft/ids.hpp>

#include "between/inner_sections.hpp"
#include "between/layer_graph.hpp"
#include "between/traced_layer.hpp"

namespace tetloft::internal::between {

struct LinkedLayers {
  /// links[k]: between layers k and k + 1, sorted.
  std::vector<std::vector<LayerLink>> links;
  std::vector<ClassId> left_apart;  ///< classes that the links leave in parts, ascending
};

/// Links regions of a class that the edges of its graph join, and those that overlap by more than
/// 0.01.
[[nodiscard]] LinkedLayers link_layers(const SlabShape& slab,
                                       const std::vector<TracedLayer>& layers,
                                       const IdVector<ClassId, LayerGraph>& solids);

}  // namespace tetloft::internal::between
