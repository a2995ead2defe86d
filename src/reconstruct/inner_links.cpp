#include "reconstruct/inner_links.hpp"

namespace tetloft::internal {

Layers layers_of(const NestedSection& lower, const NestedSection& upper,
                 const between::InnerSections& inner) {
  Layers layers{lower};
  for (const between::InnerSection& mid : inner.sections) {
    layers.push_back({mid.section, mid.nesting});
  }
  layers.push_back(upper);
  return layers;
}

IdVector<SlabId, std::vector<Link>> layer_region_links(const between::InnerSections& inner) {
  IdVector<SlabId, std::vector<Link>> links(inner.links.size());
  for (const SlabId k : links.ids()) {
    for (const between::LayerLink& link : inner.links[k.index()]) {
      links[k].push_back({k, link.below, link.above});
    }
  }
  return links;
}

}  // namespace tetloft::internal
