#include "correspondence/link_report.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "sections/complement.hpp"

namespace tetloft::internal {

namespace {

// The two largest scores among a region's pairs.
struct BestTwo {
  std::array<std::optional<double>, 2> score;

  void add(double value) {
    if (!score[0] || value > *score[0]) {
      score[1] = score[0];
      score[0] = value;
    } else if (!score[1] || value > *score[1]) {
      score[1] = value;
    }
  }
  // The largest of all but one of this value.
  [[nodiscard]] std::optional<double> beside(double value) const {
    return score[0] && *score[0] == value ? score[1] : score[0];
  }
};

std::optional<double> larger(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a ? a : b;
  return std::max(*a, *b);
}

// Of one slab. A region that is no ground for rivalry has none: the exterior.
class Rivals {
 public:
  Rivals(const SlabCandidates& candidates, const Nesting& below, const Nesting& above,
         RegionId no_ground)
      : no_ground_(no_ground), of_lower_(below.outer.size()), of_upper_(above.outer.size()) {
    for (const LinkCandidate& candidate : candidates) {
      of_lower_[candidate.link.lower].add(candidate.score());
      of_upper_[candidate.link.upper].add(candidate.score());
    }
  }

  [[nodiscard]] std::optional<double> lead(const LinkCandidate& candidate) const {
    if (candidate.lead) return candidate.lead;
    const auto rival = larger(beside(of_lower_, candidate.link.lower, candidate.score()),
                              beside(of_upper_, candidate.link.upper, candidate.score()));
    return rival ? std::optional(candidate.score() - *rival) : std::nullopt;
  }

 private:
  using OfRegions = IdVector<RegionId, BestTwo>;
  [[nodiscard]] std::optional<double> beside(const OfRegions& of, RegionId r, double value) const {
    return r == no_ground_ ? std::nullopt : of[r].beside(value);
  }

  RegionId no_ground_;
  OfRegions of_lower_, of_upper_;
};

RegionLink reported(const LinkCandidate& candidate, const Rivals& rivals) {
  RegionLink link;
  link.slab = candidate.link.slab;
  link.evidence = candidate.evidence;
  link.fate = candidate.fate;
  link.ratio = candidate.ratio;
  link.moved = candidate.moved;
  link.distance = candidate.distance;
  link.margin = candidate.margin;
  link.lead = rivals.lead(candidate);
  return link;
}

}  // namespace

std::vector<RegionLink> region_links(const StackCandidates& candidates,
                                     const IdVector<SectionId, Nesting>& nestings) {
  std::vector<RegionLink> links;
  for (const SlabId slab : candidates.ids()) {
    const Nesting& below = nestings[lower_section(slab)];
    const Nesting& above = nestings[upper_section(slab)];
    const Rivals rivals(candidates[slab], below, above, RegionId());
    for (const LinkCandidate& candidate : candidates[slab]) {
      RegionLink link = reported(candidate, rivals);
      link.lower = below.outer[candidate.link.lower];
      link.upper = above.outer[candidate.link.upper];
      links.push_back(link);
    }
  }
  return links;
}

std::vector<VoidLink> void_links(const StackCandidates& candidates,
                                 const IdVector<SectionId, Nesting>& complements) {
  const auto hole = [](const Nesting& nesting, RegionId r) {
    return r == sections::kExterior ? ContourId() : nesting.outer[r];
  };
  std::vector<VoidLink> links;
  for (const SlabId slab : candidates.ids()) {
    const Nesting& below = complements[lower_section(slab)];
    const Nesting& above = complements[upper_section(slab)];
    const Rivals rivals(candidates[slab], below, above, sections::kExterior);
    for (const LinkCandidate& candidate : candidates[slab]) {
      VoidLink link{reported(candidate, rivals)};
      link.lower = hole(below, candidate.link.lower);
      link.upper = hole(above, candidate.link.upper);
      links.push_back(link);
    }
  }
  return links;
}

}  // namespace tetloft::internal
