#include "reconstruct/clusters.hpp"

#include <utility>

#include "slab/numbering.hpp"

namespace tetloft::internal {

void MendClusters::keep(SectionId s, const Plan& plan) {
  if (planned_.contains(s)) return;
  planned_.emplace(s, AsPlanned{plan.gabriel[s], plan.apart[s], plan.divided[s]});
}

bool MendClusters::unite(SlabId slab, const std::vector<SlabId>& touched, const Beyond& beyond) {
  Beyond all = beyond;
  const auto add = [&](const Beyond& other) {
    all.below = all.below || other.below;
    all.above = all.above || other.above;
    all.decides = all.decides || other.decides;
  };
  mended_[slab] = 1;
  add(open_[SlabId(sets_.find(slab.index()))]);
  for (const SlabId k : touched) {
    mended_[k] = 1;
    add(open_[SlabId(sets_.find(k.index()))]);
    sets_.unite(slab.index(), k.index());
  }
  open_[SlabId(sets_.find(slab.index()))] = all;
  return all.any();
}

std::vector<SlabId> MendClusters::restore(SlabId of_cluster, Plan& plan) {
  std::vector<SlabId> slabs = slabs_with(of_cluster);
  for (const SlabId k : slabs) {
    for (const SectionId s : {lower_section(k), upper_section(k)}) {
      const auto known = planned_.find(s);
      if (known == planned_.end()) continue;
      plan.gabriel[s] = std::move(known->second.gabriel);
      plan.apart[s] = std::move(known->second.apart);
      plan.divided[s] = std::move(known->second.divided);
      planned_.erase(known);
    }
  }
  return slabs;
}

std::vector<SlabId> MendClusters::slabs_with(SlabId of_cluster) const {
  std::vector<SlabId> slabs;
  for (const SlabId k : open_.ids()) {
    if (sets_.same(k.index(), of_cluster.index())) slabs.push_back(k);
  }
  return slabs;
}

std::vector<OpenCluster> MendClusters::open() const {
  std::vector<OpenCluster> clusters;
  for (const SlabId k : open_.ids()) {
    if (sets_.find(k.index()) == k.index() && open_[k].any()) {
      clusters.push_back({slabs_with(k), open_[k]});
    }
  }
  return clusters;
}

std::vector<std::vector<SlabId>> MendClusters::mended() const {
  std::vector<std::vector<SlabId>> clusters;
  for (const SlabId k : open_.ids()) {
    if (sets_.find(k.index()) == k.index() && mended_[k] != 0 && !open_[k].any()) {
      clusters.push_back(slabs_with(k));
    }
  }
  return clusters;
}

}  // namespace tetloft::internal
