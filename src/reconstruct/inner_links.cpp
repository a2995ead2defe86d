#include "reconstruct/inner_links.hpp"

#include <cstddef>
#include <utility>

#include "core/guard.hpp"
#include "reconstruct/decide_voids.hpp"

namespace tetloft::internal {

std::optional<IdVector<SlabId, std::vector<Link>>> layer_void_links(
    const NestedSection& lower, const NestedSection& upper, const between::InnerSections& inner,
    const IdVector<SlabId, std::vector<Link>>& of_regions) {
  PreparedStack layers;
  const auto add = [&](const Section& section, const Nesting& nesting) {
    layers.stack.sections.push_back(section);
    layers.nestings.push_back(nesting);
  };
  add(lower.section, lower.nesting);
  for (const between::InnerSection& mid : inner.sections) add(mid.section, mid.nesting);
  add(upper.section, upper.nesting);
  const ReconstructOptions by_rule;
  const WatchedWork work(by_rule.execution, 0);
  Result<std::optional<Correspondence>> voids =
      VoidDecision(layers, by_rule).make(of_regions, work);
  if (!accepted(voids) || !*voids) return std::nullopt;
  return std::move((*voids)->links);
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
