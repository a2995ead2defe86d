// A section put together from the contours of all classes in one layer.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tetloft/ids.hpp>

#include "between/competition.hpp"
#include "between/inner_sections.hpp"
#include "between/layer_graph.hpp"

namespace tetloft::internal::between {

struct TracedLayer {
  InnerSection inner;
  /// By class and node of its graph of solids: the region.
  IdVector<ClassId, std::vector<RegionId>> region_of;
};

/// Of a layer between, at this height; after part_contours(). None where rounding leaves no valid
/// section.
[[nodiscard]] std::optional<TracedLayer> trace_layer(const ClassShapes& shapes,
                                                     const IdVector<ClassId, LayerGraph>& solids,
                                                     std::size_t layer, double z, double step);

}  // namespace tetloft::internal::between
