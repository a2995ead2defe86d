// Oblique tubes: a region that nothing overlaps is moved on by as much as it moved from the
// section before, in proportion to the gaps, and is matched with what it overlaps there.
#include "correspondence/chain_links.hpp"

#include <algorithm>
#include <utility>

#include "correspondence/moved_region.hpp"
#include "correspondence/overlap_links.hpp"
#include "sections/complement.hpp"

namespace tetloft::internal {

namespace {

using sections::kExterior;

// The candidates of a region in one slab: how many, and with which region the last of them is.
struct Partners {
  std::size_t count = 0;
  RegionId last;
};

using RegionPartners = IdVector<RegionId, Partners>;

RegionPartners partners_of(std::size_t regions, const SlabCandidates& candidates, bool upper,
                           const ChainRule& rule) {
  RegionPartners result(regions);
  if (rule.voids) result[kExterior] = {1, kExterior};
  for (const LinkCandidate& candidate : candidates) {
    if (!candidate.made()) continue;
    const Link& link = candidate.link;
    Partners& partners = result[upper ? link.upper : link.lower];
    ++partners.count;
    partners.last = upper ? link.lower : link.upper;
  }
  return result;
}

// One way through a slab: regions of `from` are moved on to `to`, as they came from `behind`.
class Passage {
 public:
  Passage(const SectionRegions& behind, const RegionPartners& origins, const SectionRegions& from,
          const SectionRegions& to, const ChainRule& rule)
      : behind_(behind), origins_(origins), from_(from), to_(to), rule_(rule) {}

  // The region moved on, if it has an origin and remains a region.
  [[nodiscard]] std::optional<MovedRegion> moved_on(RegionId r) const {
    const std::optional<RegionId> origin = origin_of(r);
    if (!origin) return std::nullopt;
    const double scale = gap(from_, to_) / gap(behind_, from_);
    const Point2 here = from_.centre(r);
    const Point2 there = behind_.centre(*origin);
    return moved(from_.outline[r], {(here.x - there.x) * scale, (here.y - there.y) * scale});
  }

 private:
  static double gap(const SectionRegions& a, const SectionRegions& b) {
    return std::max(a.z, b.z) - std::min(a.z, b.z);
  }

  [[nodiscard]] std::optional<RegionId> origin_of(RegionId r) const {
    const Partners& partners = origins_[r];
    if (partners.count > 1) return std::nullopt;
    if (partners.count == 1) {
      return is_origin(partners.last) ? std::optional(partners.last) : std::nullopt;
    }
    std::optional<RegionId> nearest;
    double reach = rule_.reach;
    const bool up = behind_.z < from_.z;
    behind_.for_each_near(grown(from_.box[r], reach * gap(behind_, from_)), [&](RegionId q) {
      if (!is_origin(q)) return;
      const auto d =
          up ? gaps_apart(behind_, q, from_, r, reach) : gaps_apart(from_, r, behind_, q, reach);
      if (!d || (nearest && !(*d < reach))) return;
      nearest = q;
      reach = *d;
    });
    return nearest;
  }
  [[nodiscard]] bool is_origin(RegionId r) const { return !rule_.voids || r != kExterior; }

  const SectionRegions& behind_;
  const RegionPartners& origins_;
  const SectionRegions& from_;
  const SectionRegions& to_;
  const ChainRule& rule_;
};

// The single regions of a slab, and the pairs of them that are within reach.
class SlabSingles {
 public:
  SlabSingles(SlabId slab, const SectionRegions& below, const SectionRegions& above,
              const SlabCandidates& candidates, const ChainRule& rule)
      : slab_(slab),
        reach_(rule.reach),
        below_(below),
        above_(above),
        of_below_(partners_of(below.size(), candidates, false, rule)),
        of_above_(partners_of(above.size(), candidates, true, rule)) {}

  [[nodiscard]] SlabCandidates pairs_within_reach() const {
    SlabCandidates pairs;
    for (const RegionId i : below_.ids()) {
      if (of_below_[i].count > 0) continue;
      const Box2 near = grown(below_.box[i], reach_ * (above_.z - below_.z));
      above_.for_each_near(near, [&](RegionId j) {
        if (of_above_[j].count > 0) return;
        const auto d = gaps_apart(below_, i, above_, j, reach_);
        if (!d) return;
        LinkCandidate pair{{slab_, i, j}, Evidence::chain, LinkFate::too_weak};
        pair.distance = *d;
        if (*d == 0) pair.ratio = overlap_ratio(below_.outline[i], above_.outline[j]);
        pairs.push_back(pair);
      });
    }
    return pairs;
  }

  // Raises the moved ratios of pairs to those of regions moved on along this passage.
  void measure(const Passage& passage, bool upwards, SlabCandidates& pairs) const {
    IdVector<RegionId, std::vector<LinkCandidate*>> of((upwards ? below_ : above_).size());
    for (LinkCandidate& pair : pairs)
      of[upwards ? pair.link.lower : pair.link.upper].push_back(&pair);
    for (const RegionId r : of.ids()) {
      if (of[r].empty()) continue;
      const std::optional<MovedRegion> on = passage.moved_on(r);
      if (!on) continue;
      const RegionOutline outline = on->outline();
      for (LinkCandidate* const pair : of[r]) {
        const RegionOutline& met =
            upwards ? above_.outline[pair->link.upper] : below_.outline[pair->link.lower];
        const double ratio = overlap_ratio(outline, met);
        if (compare_overlap(outline, met, kChainOverlap, ratio) == Sign::positive)
          pair->fate = LinkFate::made;
        pair->moved = std::max(pair->moved, ratio);
      }
    }
  }

 private:
  SlabId slab_;
  double reach_;
  const SectionRegions& below_;
  const SectionRegions& above_;
  RegionPartners of_below_, of_above_;
};

}  // namespace

SlabCandidates chain_links(SlabId slab, const StackSections& sections,
                           const StackCandidates& by_criterion, const ChainRule& rule) {
  const SectionId below(slab.index());
  const SectionId above(slab.index() + 1);
  const SlabSingles singles(slab, sections[below], sections[above], by_criterion[slab], rule);
  SlabCandidates pairs = singles.pairs_within_reach();
  if (pairs.empty()) return pairs;
  if (slab.index() > 0) {
    const SectionRegions& behind = sections[SectionId(slab.index() - 1)];
    const RegionPartners origins =
        partners_of(sections[below].size(), by_criterion[SlabId(slab.index() - 1)], true, rule);
    singles.measure(Passage(behind, origins, sections[below], sections[above], rule), true, pairs);
  }
  if (slab.index() + 1 < by_criterion.size()) {
    const SectionRegions& behind = sections[SectionId(slab.index() + 2)];
    const RegionPartners origins =
        partners_of(sections[above].size(), by_criterion[SlabId(slab.index() + 1)], false, rule);
    singles.measure(Passage(behind, origins, sections[above], sections[below], rule), false, pairs);
  }
  std::erase_if(pairs, [](const LinkCandidate& pair) { return pair.moved == 0; });
  for (LinkCandidate& pair : pairs) pair.margin = pair.moved - kChainOverlap;
  return pairs;
}

}  // namespace tetloft::internal
