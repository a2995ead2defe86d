#include "reconstruct/classes.hpp"

#include "core/union_find.hpp"

namespace tetloft {

SlabClasses::SlabClasses(const ConformingSection& lower, const ConformingSection& upper,
                         const std::vector<Link>& links)
    : lower_regions_(lower.nesting.outer.size()) {
  const std::size_t regions = lower_regions_ + upper.nesting.outer.size();
  UnionFind sets(regions);
  for (const Link& link : links) {
    sets.unite(link.lower.index(), lower_regions_ + link.upper.index());
  }

  class_of_region_.resize(regions);
  for (std::size_t r = 0; r < regions; ++r) {
    // A set's representative is its smallest element, hence numbered before the others.
    const SlabRegionId leader(sets.find(r));
    if (leader.index() == r) class_of_region_[leader] = members_.push_back({});
    class_of_region_[SlabRegionId(r)] = class_of_region_[leader];
    members_[class_of_region_[leader]].push_back(SlabRegionId(r));
  }

  region_of_vertex_.reserve(lower.vertex_count() + upper.vertex_count());
  bool exterior = false;
  const auto add_vertex = [&](RegionId r, std::size_t first) {
    region_of_vertex_.push_back(SlabRegionId(r.valid() ? first + r.index() : regions));
    exterior = exterior || !r.valid();
  };
  for (const RegionId r : lower.region) add_vertex(r, 0);
  for (const RegionId r : upper.region) add_vertex(r, lower_regions_);
  if (exterior) {
    exterior_ = members_.push_back({});
    class_of_region_.push_back(exterior_);
  }
}

}  // namespace tetloft
