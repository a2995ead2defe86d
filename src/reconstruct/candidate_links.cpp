// The two automatic criteria of correspondence.
#include <algorithm>
#include <array>

#include "reconstruct/contour_box.hpp"
#include "reconstruct/correspondence.hpp"

namespace tetloft {

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
  std::vector<std::uint32_t> strong_below(lows, 0);  // number of strong links of a region
  std::vector<std::uint32_t> strong_above(highs, 0);
  for (std::size_t i = 0; i < lows; ++i) {
    const ContourBox low_box = box_of(below.contours[nesting_below.outer[RegionId(i)]]);
    for (std::size_t j = 0; j < highs; ++j) {
      if (!low_box.meets(high_box[j])) continue;
      const auto [against_strong, against_tau] = compare_overlap(
          low_outline[RegionId(i)], high_outline[RegionId(j)], std::array{kStrongOverlap, tau});
      const bool strong = against_strong != Sign::negative;
      if (strong) {
        ++strong_below[i];
        ++strong_above[j];
      }
      if (against_tau != Sign::positive) continue;
      candidates.push_back({{slab, RegionId(i), RegionId(j)}, strong});
    }
  }

  std::vector<Link> links;
  for (const Candidate& c : candidates) {
    // The guard: a weak link between two regions that are well connected elsewhere is
    // taken for a coincidence of neighbours.
    if (!c.strong && strong_below[c.link.lower.index()] > 0 &&
        strong_above[c.link.upper.index()] > 0) {
      continue;
    }
    links.push_back(c.link);
  }
  return links;
}

std::vector<Link> reverse_links(SlabId id, const Slab& slab) {
  std::vector<Link> links;
  for (std::size_t k = 0; k < slab.mesh().tet_slots(); ++k) {
    const TetId t(k);
    if (slab.kind(t) != TetKind::ii && slab.kind(t) != TetKind::ie) continue;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const VertexId low = slab.mesh().vertex(t, i);
        const VertexId high = slab.mesh().vertex(t, j);
        if (slab.is_upper(low) || !slab.is_upper(high)) continue;
        links.push_back({id, slab.lower().region[low], slab.upper().region[slab.in_section(high)]});
      }
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

}  // namespace tetloft
