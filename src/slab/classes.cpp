#include "slab/classes.hpp"

#include "core/union_find.hpp"

namespace tetloft::internal {

SlabClasses::SlabClasses(const ConformingSection& lower, const ConformingSection& upper,
                         const std::vector<Link>& links)
    : regions_(lower.nesting.outer.size(), upper.nesting.outer.size()) {
  UnionFind sets(regions_.size());
  for (const Link& link : links) {
    sets.unite(regions_.in_slab(false, link.lower).index(),
               regions_.in_slab(true, link.upper).index());
  }

  class_of_region_.resize(regions_.size());
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    // A set's representative is its smallest element, hence numbered before the others.
    const SlabRegionId leader(sets.find(r));
    if (leader.index() == r) class_of_region_[leader] = members_.push_back({});
    class_of_region_[SlabRegionId(r)] = class_of_region_[leader];
    members_[class_of_region_[leader]].push_back(SlabRegionId(r));
  }

  region_of_vertex_.reserve(lower.vertex_count() + upper.vertex_count());
  bool exterior = false;
  for (const bool above : {false, true}) {
    for (const RegionId r : (above ? upper : lower).region) {
      region_of_vertex_.push_back(r.valid() ? regions_.in_slab(above, r)
                                            : SlabRegionId(regions_.size()));
      exterior = exterior || !r.valid();
    }
  }
  if (exterior) {
    exterior_ = members_.push_back({});
    class_of_region_.push_back(exterior_);
  }
  class_of_vertex_.reserve(region_of_vertex_.size());
  for (const SlabRegionId r : region_of_vertex_) class_of_vertex_.push_back(class_of_region_[r]);
}

}  // namespace tetloft::internal
