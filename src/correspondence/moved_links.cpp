#include "correspondence/moved_links.hpp"

#include <algorithm>
#include <vector>

#include "correspondence/moved_ratio.hpp"
#include "correspondence/overlap_links.hpp"

namespace tetloft::internal {

namespace {

// A pair that overlaps so far, and nothing else, stays where it is.
constexpr double kClearOverlap = 0.5;

}  // namespace

SlabMotions motions_where_unclear(SlabId slab, const SectionStack& stack,
                                  const IdVector<SectionId, Nesting>& nestings,
                                  const SectionRegions& below, const SectionRegions& above) {
  const std::vector<OverlappingPair> pairs = overlapping_pairs(below, above);
  IdVector<RegionId, std::size_t> of_lower(below.size(), 0);
  IdVector<RegionId, std::size_t> of_upper(above.size(), 0);
  for (const OverlappingPair& pair : pairs) {
    ++of_lower[pair.lower];
    ++of_upper[pair.upper];
  }
  IdVector<RegionId, std::uint8_t> clear_lower(below.size(), 0);
  IdVector<RegionId, std::uint8_t> clear_upper(above.size(), 0);
  for (const auto& [lower, upper, ratio] : pairs) {
    if (of_lower[lower] == 1 && of_upper[upper] == 1 && ratio >= kClearOverlap) {
      clear_lower[lower] = clear_upper[upper] = 1;
    }
  }
  WantedRegions wanted;
  for (const RegionId r : below.ids()) {
    if (clear_lower[r] == 0) wanted.lower.push_back(r);
  }
  for (const RegionId r : above.ids()) {
    if (clear_upper[r] == 0) wanted.upper.push_back(r);
  }
  SlabMotions motions{IdVector<RegionId, std::optional<Point2>>(below.size()),
                      IdVector<RegionId, std::optional<Point2>>(above.size())};
  if (wanted.lower.empty() && wanted.upper.empty()) return motions;
  // Nothing moves where there is nothing to move to.
  if (below.size() == 0 || above.size() == 0) return motions;
  return estimate_motions(slab, stack, nestings, wanted);
}

SlabCandidates moved_links(SlabId slab, const SectionRegions& below, const SectionRegions& above,
                           const SlabMotions& motions, double tau) {
  const MovedPairs moved(below, above, motions);
  SlabCandidates candidates;
  for (const RegionId i : below.ids()) {
    for (const RegionId j : above.ids()) {
      if (!moved.reach_of_lower(i).meets(moved.reach_of_upper(j))) continue;
      // No ratio exceeds 1.
      const auto d = gaps_apart(below, i, above, j, 1 - tau);
      if (!d) continue;
      LinkCandidate candidate{{slab, i, j}};
      candidate.ratio = overlap_ratio(below.outline[i], above.outline[j]);
      candidate.moved = moved.ratio(i, j);
      candidate.distance = *d;
      candidate.margin = candidate.score() - tau;
      if (candidate.ratio == 0 && candidate.score() <= 0) continue;
      if (!moved.exceeds(i, j, tau + *d)) candidate.fate = LinkFate::too_weak;
      if (!(candidate.ratio > tau)) candidate.evidence = Evidence::motion;
      candidates.push_back(candidate);
    }
  }
  return candidates;
}

}  // namespace tetloft::internal
