#include "correspondence/moved_links.hpp"

#include <algorithm>
#include <vector>

#include "correspondence/moved_ratio.hpp"

namespace tetloft::internal {

namespace {

// Of each region of a section.
using Flags = IdVector<RegionId, std::uint8_t>;

struct Unclear {
  Flags lower, upper;
};

// The regions that are not at rest: some pair that they, or their partners, overlap in is weak, or
// they overlap nothing.
Unclear unclear_regions(const SectionRegions& below, const SectionRegions& above,
                        const std::vector<OverlappingPair>& pairs) {
  Flags weak_lower(below.size(), 0);
  Flags weak_upper(above.size(), 0);
  Unclear unclear{Flags(below.size(), 1), Flags(above.size(), 1)};
  for (const auto& [lower, upper, ratio] : pairs) {
    unclear.lower[lower] = unclear.upper[upper] = 0;
    const Sign rest =
        compare_overlap(below.outline[lower], above.outline[upper], kRestOverlap, ratio);
    if (rest == Sign::negative) weak_lower[lower] = weak_upper[upper] = 1;
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
                                  const SectionRegions& below, const SectionRegions& above,
                                  const std::vector<OverlappingPair>& overlapping) {
  const Unclear unclear = unclear_regions(below, above, overlapping);
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
                           const std::vector<OverlappingPair>& overlapping,
                           const SlabMotions& motions, double tau) {
  const MovedPairs moved(below, above, motions);
  SlabCandidates candidates;
  const auto add = [&](RegionId lower, RegionId upper, double r, double d) {
    LinkCandidate candidate{{slab, lower, upper}};
    candidate.ratio = r;
    candidate.moved = moved.ratio(lower, upper, r);
    candidate.distance = d;
    candidate.margin = candidate.moved - (tau + d);
    if (r == 0 && candidate.score() <= 0) return;
    if (!(candidate.moved > tau + d)) candidate.fate = LinkFate::too_weak;
    if (!(r > tau)) candidate.evidence = Evidence::motion;
    candidates.push_back(candidate);
  };
  for (const auto& [lower, upper, ratio] : overlapping) add(lower, upper, ratio, 0);
  const std::size_t known = candidates.size();
  for (const auto& [lower, upper] : moved.near_where_moved()) {
    const auto last = candidates.begin() + static_cast<std::ptrdiff_t>(known);
    const auto at = std::lower_bound(
        candidates.begin(), last, Link{slab, lower, upper},
        [](const LinkCandidate& candidate, const Link& link) { return candidate.link < link; });
    if (at != last && at->link == Link{slab, lower, upper}) continue;
    // No ratio exceeds 1.
    if (const auto d = gaps_apart(below, lower, above, upper, 1)) add(lower, upper, 0, *d);
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const LinkCandidate& a, const LinkCandidate& b) { return a.link < b.link; });
  return candidates;
}

}  // namespace tetloft::internal
