#include "correspondence/link_report.hpp"

#include <algorithm>
#include <array>
#include <optional>

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

}  // namespace

std::vector<RegionLink> region_links(const StackCandidates& candidates,
                                     const IdVector<SectionId, Nesting>& nestings) {
  std::vector<RegionLink> links;
  for (const SlabId slab : candidates.ids()) {
    const Nesting& below = nestings[lower_section(slab)];
    const Nesting& above = nestings[upper_section(slab)];
    IdVector<RegionId, BestTwo> of_lower(below.outer.size());
    IdVector<RegionId, BestTwo> of_upper(above.outer.size());
    for (const LinkCandidate& candidate : candidates[slab]) {
      of_lower[candidate.link.lower].add(candidate.score());
      of_upper[candidate.link.upper].add(candidate.score());
    }
    for (const LinkCandidate& candidate : candidates[slab]) {
      const auto& [in, lower, upper] = candidate.link;
      const auto rival = larger(of_lower[lower].beside(candidate.score()),
                                of_upper[upper].beside(candidate.score()));
      RegionLink link{slab, below.outer[lower], above.outer[upper], candidate.evidence,
                      candidate.fate};
      link.ratio = candidate.ratio;
      link.moved = candidate.moved;
      link.distance = candidate.distance;
      link.margin = candidate.margin;
      link.lead = candidate.lead;
      if (!link.lead && rival) link.lead = candidate.score() - *rival;
      links.push_back(link);
    }
  }
  return links;
}

}  // namespace tetloft::internal
