// Rule 1, `overlap`: regions that overlap by more than the threshold, and the guard.
#include <algorithm>

#include "check/partition.hpp"

namespace tetloft::internal::checking {

namespace {

struct Overlap {
  Link link;
  bool strong = false;  // r ≥ kStrongOverlap, 1/4
};

// All pairs of one slab with r > tau.
std::vector<Overlap> overlaps_in_slab(const Regions& regions, std::size_t slab, double tau) {
  std::vector<Overlap> overlaps;
  for (std::size_t r = regions.first[slab]; r < regions.first[slab + 1]; ++r) {
    regions.for_each_meeting(slab + 1, regions.box[r], [&](std::size_t q) {
      const auto [over_tau, over_strong] =
          compare_overlap(regions.shape[r], regions.shape[q], {tau, kStrongOverlap});
      if (over_tau == Sign::positive) {
        overlaps.push_back({{r, q}, over_strong != Sign::negative});
      }
    });
  }
  return overlaps;
}

}  // namespace

std::vector<Link> overlap_links(const Regions& regions, double tau) {
  std::vector<Link> links;
  for (std::size_t slab = 0; slab + 1 < regions.section_count(); ++slab) {
    const std::vector<Overlap> overlaps = overlaps_in_slab(regions, slab, tau);
    // A weak link has no strong one to discount: any strong link of its regions is another.
    std::set<std::size_t> has_strong;
    for (const Overlap& overlap : overlaps) {
      if (!overlap.strong) continue;
      has_strong.insert(overlap.link.lower);
      has_strong.insert(overlap.link.upper);
    }
    for (const auto& [link, strong] : overlaps) {
      const bool outruled =
          !strong && has_strong.count(link.lower) != 0 && has_strong.count(link.upper) != 0;
      if (!outruled) links.push_back(link);
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

}  // namespace tetloft::internal::checking
