#include "correspondence/overlap_links.hpp"

#include <cmath>
#include <optional>

#include "sections/overlap_region.hpp"

namespace tetloft::internal {

std::vector<OverlappingPair> overlapping_pairs(const SectionRegions& below,
                                               const SectionRegions& above) {
  // Each region is made ready once, if it is near another.
  IdVector<RegionId, std::optional<sections::OverlapRegion>> ready(above.size());
  std::vector<OverlappingPair> pairs;
  for (const RegionId i : below.ids()) {
    std::optional<sections::OverlapRegion> low;
    above.for_each_near(below.box[i], [&](RegionId j) {
      if (!below.box[i].overlaps(above.box[j])) return;
      if (!low) low.emplace(below.outline[i]);
      if (!ready[j]) ready[j].emplace(above.outline[j]);
      const double ratio = sections::overlap_ratio(*low, *ready[j]);
      if (ratio > 0) pairs.push_back({i, j, ratio});
    });
  }
  return pairs;
}

Sign compare_overlap(const RegionOutline& a, const RegionOutline& b, double tau, double ratio) {
  if (std::abs(ratio - tau) > sections::kRatioError * ratio) {
    return ratio > tau ? Sign::positive : Sign::negative;
  }
  return tetloft::compare_overlap(a, b, tau);
}

SlabCandidates overlap_links(SlabId slab, const SectionRegions& below, const SectionRegions& above,
                             double tau) {
  SlabCandidates candidates;
  // Has a region a strong link?
  IdVector<RegionId, std::uint8_t> strong_below(below.size(), 0);
  IdVector<RegionId, std::uint8_t> strong_above(above.size(), 0);
  std::vector<bool> strong;
  for (const auto& [i, j, ratio] : overlapping_pairs(below, above)) {
    const RegionOutline& low = below.outline[i];
    const RegionOutline& high = above.outline[j];
    strong.push_back(compare_overlap(low, high, kStrongOverlap, ratio) != Sign::negative);
    if (strong.back()) strong_below[i] = strong_above[j] = 1;
    LinkCandidate candidate{{slab, i, j}};
    candidate.ratio = candidate.moved = ratio;
    candidate.margin = ratio - tau;
    if (compare_overlap(low, high, tau, ratio) != Sign::positive) {
      candidate.fate = LinkFate::too_weak;
    }
    candidates.push_back(candidate);
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    LinkCandidate& candidate = candidates[k];
    const auto& [in, low, high] = candidate.link;
    // The guard: a weak link between two regions that are well connected elsewhere is
    // taken for a coincidence of neighbours.
    if (strong[k] || strong_below[low] == 0 || strong_above[high] == 0) continue;
    if (!candidate.made()) continue;
    candidate.fate = LinkFate::outruled;
    candidate.margin = candidate.ratio - kStrongOverlap;
  }
  return candidates;
}

}  // namespace tetloft::internal
