#include "correspondence/overlap_links.hpp"

#include <array>

#include <tetloft/overlap.hpp>

#include "correspondence/contour_box.hpp"

namespace tetloft::internal {

std::vector<Link> overlap_links(SlabId slab, const Section& below, const Nesting& nesting_below,
                                const Section& above, const Nesting& nesting_above, double tau) {
  struct Candidate {
    Link link;
    bool strong;
  };
  const std::size_t lows = nesting_below.outer.size();
  const std::size_t highs = nesting_above.outer.size();
  std::vector<ContourBox> high_box(highs);
  const IdVector<RegionId, RegionOutline> low_outline = outlines(below, nesting_below);
  const IdVector<RegionId, RegionOutline> high_outline = outlines(above, nesting_above);
  for (std::size_t j = 0; j < highs; ++j) {
    high_box[j] = box_of(above.contours[nesting_above.outer[RegionId(j)]]);
  }

  std::vector<Candidate> candidates;
  // Has a region a strong link?
  IdVector<RegionId, std::uint8_t> strong_below(lows, 0);
  IdVector<RegionId, std::uint8_t> strong_above(highs, 0);
  for (std::size_t i = 0; i < lows; ++i) {
    const ContourBox low_box = box_of(below.contours[nesting_below.outer[RegionId(i)]]);
    for (std::size_t j = 0; j < highs; ++j) {
      if (!low_box.meets(high_box[j])) continue;
      const auto [against_strong, against_tau] = compare_overlap(
          low_outline[RegionId(i)], high_outline[RegionId(j)], std::array{kStrongOverlap, tau});
      const bool strong = against_strong != Sign::negative;
      if (strong) strong_below[RegionId(i)] = strong_above[RegionId(j)] = 1;
      if (against_tau != Sign::positive) continue;
      candidates.push_back({{slab, RegionId(i), RegionId(j)}, strong});
    }
  }

  std::vector<Link> links;
  for (const Candidate& c : candidates) {
    // The guard: a weak link between two regions that are well connected elsewhere is
    // taken for a coincidence of neighbours.
    if (!c.strong && strong_below[c.link.lower] != 0 && strong_above[c.link.upper] != 0) {
      continue;
    }
    links.push_back(c.link);
  }
  return links;
}

}  // namespace tetloft::internal
