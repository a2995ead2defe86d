#include "between/trace_shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "between/layer_links.hpp"
#include "between/reeb_rule.hpp"
#include "between/traced_layer.hpp"

namespace tetloft::internal::between {

namespace {

// Heights of the layers between; none where doubles do not hold them apart.
std::vector<double> heights(const SlabShape& slab) {
  std::vector<double> result;
  double below = slab.lower.z;
  for (const double at : slab.at) {
    const double z = slab.lower.z + at * (slab.upper.z - slab.lower.z);
    if (!(below < z && z < slab.upper.z)) return {};
    result.push_back(below = z);
  }
  return result;
}

// Does every class have values, in windows whose places have numbers of 32 bits?
bool are_sampled(const SlabShape& slab, const ClassShapes& shapes) {
  if (shapes.size() != slab.classes.size()) return false;
  return std::all_of(shapes.begin(), shapes.end(), [&](const ClassShape& shape) {
    return shape.window.size() > 0 &&
           shape.window.size() < std::numeric_limits<std::uint32_t>::max() &&
           shape.value.size() == slab.at.size() + 2;
  });
}

}  // namespace

TracedShapes trace_shapes(const SlabShape& slab, ClassShapes& shapes,
                          const std::vector<ClassId>& bridged) {
  TracedShapes result;
  const std::vector<double> z = heights(slab);
  if (z.empty() || !are_sampled(slab, shapes)) return result;
  const std::vector<MeetingWindows> meetings = meeting_windows(shapes);
  compete(shapes, meetings);
  IdVector<ClassId, LayerGraph> solids;
  for (const ClassId c : shapes.ids()) {
    const bool bridge = std::binary_search(bridged.begin(), bridged.end(), c);
    solids.push_back(apply_reeb_rule({slab, shapes, meetings}, c,
                                     bridge ? ApartParts::bridged : ApartParts::stay));
  }
  part_contours(shapes, meetings);
  std::vector<TracedLayer> layers;
  for (std::size_t k = 0; k < z.size(); ++k) {
    std::optional<TracedLayer> layer = trace_layer(shapes, solids, k + 1, z[k], slab.step);
    if (!layer) return result;
    layers.push_back(std::move(*layer));
  }
  LinkedLayers linked = link_layers(slab, layers, solids);
  result.left_apart = std::move(linked.left_apart);
  if (!result.left_apart.empty()) return result;
  result.inner.links = std::move(linked.links);
  for (TracedLayer& layer : layers) result.inner.sections.push_back(std::move(layer.inner));
  return result;
}

}  // namespace tetloft::internal::between
