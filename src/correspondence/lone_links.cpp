// A region that nothing links is as a rule the tip of a part, or the part itself lies so thin or
// oblique that sections miss what joins it: it belongs to what is nearest, if that is near enough.
#include "correspondence/lone_links.hpp"

#include <algorithm>
#include <optional>

#include "correspondence/moved_ratio.hpp"

namespace tetloft::internal {

namespace {

// How far regions are looked for, in gaps, so that what was nearest can be told.
constexpr double kLookout = 2.0;

class LoneRegions {
 public:
  LoneRegions(SectionId section, const StackSections& sections, const StackCandidates& candidates,
              const IdVector<SlabId, SlabMotions>& motions)
      : section_(section), sections_(sections), motions_(motions), own_(sections[section]) {
    lone_.assign(own_.size(), 1);
    if (const auto slab = slab_below()) mark_linked(candidates[*slab], true);
    if (const auto slab = slab_above()) mark_linked(candidates[*slab], false);
  }

  [[nodiscard]] std::vector<LinkCandidate> links() {
    std::vector<LinkCandidate> links;
    if (std::find(lone_.begin(), lone_.end(), 1) == lone_.end()) return links;
    if (const auto slab = slab_below()) moved_below_.emplace(pairs_of(*slab));
    if (const auto slab = slab_above()) moved_above_.emplace(pairs_of(*slab));
    for (const RegionId r : own_.ids()) {
      if (lone_[r] == 0) continue;
      if (const auto link = preferred(r)) links.push_back(*link);
    }
    return links;
  }

 private:
  [[nodiscard]] std::optional<SlabId> slab_below() const {
    if (section_.index() == 0) return std::nullopt;
    return SlabId(section_.index() - 1);
  }
  [[nodiscard]] std::optional<SlabId> slab_above() const {
    if (section_.index() + 1 == sections_.size()) return std::nullopt;
    return SlabId(section_.index());
  }

  [[nodiscard]] MovedPairs pairs_of(SlabId slab) const {
    return {sections_[lower_section(slab)], sections_[upper_section(slab)], motions_[slab]};
  }

  void mark_linked(const SlabCandidates& candidates, bool upper) {
    for (const LinkCandidate& candidate : candidates) {
      if (candidate.made()) lone_[upper ? candidate.link.upper : candidate.link.lower] = 0;
    }
  }

  // The pairs of region r in one slab, as far as the lookout, in order of the other region.
  void add_pairs(RegionId r, SlabId slab, std::vector<LinkCandidate>& pairs) const {
    const bool upper = slab.index() < section_.index();
    const SectionRegions& below = sections_[lower_section(slab)];
    const SectionRegions& above = sections_[upper_section(slab)];
    const SectionRegions& others = upper ? below : above;
    const double gap = above.z - below.z;
    const MovedPairs& moved = upper ? *moved_below_ : *moved_above_;
    const bool small = compare_area(own_.outline[r], gap / 2) == Sign::negative;
    others.for_each_near(grown(own_.box[r], kLookout * gap), [&](RegionId q) {
      LinkCandidate pair{{slab, upper ? q : r, upper ? r : q}, Evidence::lone};
      const auto& [id, lower, higher] = pair.link;
      pair.ratio = overlap_ratio(below.outline[lower], above.outline[higher]);
      const auto d =
          pair.ratio > 0 ? std::optional(0.0) : gaps_apart(below, lower, above, higher, kLookout);
      if (!d) return;
      pair.moved = moved.ratio(lower, higher, pair.ratio);
      pair.distance = *d;
      pair.margin = (small ? kSmallLoneReach : kLoneReach) - *d;
      pair.fate = pair.margin > 0 ? LinkFate::made : LinkFate::too_weak;
      pairs.push_back(pair);
    });
  }

  // Among the pairs within reach, or else among all.
  [[nodiscard]] std::optional<LinkCandidate> preferred(RegionId r) const {
    std::vector<LinkCandidate> pairs;
    if (const auto slab = slab_below()) add_pairs(r, *slab, pairs);
    if (const auto slab = slab_above()) add_pairs(r, *slab, pairs);
    if (pairs.empty()) return std::nullopt;
    const auto better = [](const LinkCandidate& a, const LinkCandidate& b) {
      return a.made() != b.made() ? a.made() : a.score() > b.score();
    };
    std::stable_sort(pairs.begin(), pairs.end(), better);
    if (pairs.size() > 1) pairs[0].lead = pairs[0].score() - pairs[1].score();
    return pairs[0];
  }

  SectionId section_;
  const StackSections& sections_;
  const IdVector<SlabId, SlabMotions>& motions_;
  const SectionRegions& own_;
  IdVector<RegionId, std::uint8_t> lone_;
  std::optional<MovedPairs> moved_below_, moved_above_;  // of the slabs beside, once there is one
};

}  // namespace

std::vector<LinkCandidate> lone_links(SectionId section, const StackSections& sections,
                                      const StackCandidates& candidates,
                                      const IdVector<SlabId, SlabMotions>& motions) {
  return LoneRegions(section, sections, candidates, motions).links();
}

}  // namespace tetloft::internal
