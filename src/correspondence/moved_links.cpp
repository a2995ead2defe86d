#include "correspondence/moved_links.hpp"

#include <algorithm>
#include <vector>

#include "correspondence/moved_ratio.hpp"
#include "correspondence/overlap_links.hpp"

namespace tetloft::internal {

namespace {

// Of each region of a slab's section: does it overlap something?
using Flags = IdVector<RegionId, std::uint8_t>;

struct Unclear {
  Flags lower, upper;
};

// The regions that are not at rest: some pair that they, or their partners, overlap in is weak, or
// they overlap nothing.
Unclear unclear_regions(const SectionRegions& below, const SectionRegions& above) {
  const std::vector<OverlappingPair> pairs = overlapping_pairs(below, above);
  Flags weak_lower(below.size(), 0);
  Flags weak_upper(above.size(), 0);
  Unclear unclear{Flags(below.size(), 1), Flags(above.size(), 1)};
  for (const auto& [lower, upper, ratio] : pairs) {
    unclear.lower[lower] = unclear.upper[upper] = 0;
    if (!reaches(below.outline[lower], above.outline[upper], ratio, kRestOverlap)) {
      weak_lower[lower] = weak_upper[upper] = 1;
    }
  }
  for (const auto& [lower, upper, ratio] : pairs) {
    if (weak_lower[lower] != 0 || weak_upper[upper] != 0) {
      unclear.lower[lower] = unclear.upper[upper] = 1;
    }
  }
  return unclear;
}

// Those of them that something of the other section is near enough to move to.
std::vector<RegionId> movable(const SectionRegions& section, const Flags& unclear,
                              const SectionRegions& other, double gap) {
  std::vector<RegionId> result;
  for (const RegionId r : section.ids()) {
    if (unclear[r] == 0) continue;
    const Box2& box = section.box[r];
    bool near = false;
    other.for_each_near({box.x0 - gap, box.y0 - gap, box.x1 + gap, box.y1 + gap},
                        [&](RegionId) { near = true; });
    if (near) result.push_back(r);
  }
  return result;
}

}  // namespace

SlabMotions motions_where_unclear(SlabId slab, const SectionStack& stack,
                                  const IdVector<SectionId, Nesting>& nestings,
                                  const SectionRegions& below, const SectionRegions& above) {
  const Unclear unclear = unclear_regions(below, above);
  const double gap = above.z - below.z;
  const WantedRegions wanted{movable(below, unclear.lower, above, gap),
                             movable(above, unclear.upper, below, gap)};
  if (wanted.lower.empty() && wanted.upper.empty()) {
    return {IdVector<RegionId, std::optional<Point2>>(below.size()),
            IdVector<RegionId, std::optional<Point2>>(above.size())};
  }
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
      if (!(candidate.moved > tau + *d)) candidate.fate = LinkFate::too_weak;
      if (!(candidate.ratio > tau)) candidate.evidence = Evidence::motion;
      candidates.push_back(candidate);
    }
  }
  return candidates;
}

}  // namespace tetloft::internal
