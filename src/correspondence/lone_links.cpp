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

  [[nodiscard]] std::vector<LinkCandidate> links() const {
    std::vector<LinkCandidate> links;
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
    const MovedPairs moved(below, above, motions_[slab]);
    const bool small = compare_area(own_.outline[r], gap / 2) == Sign::negative;
    others.for_each_near(grown(own_.box[r], kLookout * gap), [&](RegionId q) {
      LinkCandidate pair{{slab, upper ? q : r, upper ? r : q}, Evidence::lone};
      const auto& [id, lower, higher] = pair.link;
      const auto d = gaps_apart(below, lower, above, higher, kLookout);
      if (!d) return;
      pair.ratio = overlap_ratio(below.outline[lower], above.outline[higher]);
      pair.moved = moved.ratio(lower, higher);
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
};

}  // namespace

std::vector<LinkCandidate> lone_links(SectionId section, const StackSections& sections,
                                      const StackCandidates& candidates,
                                      const IdVector<SlabId, SlabMotions>& motions) {
  return LoneRegions(section, sections, candidates, motions).links();
}

}  // namespace tetloft::internal
