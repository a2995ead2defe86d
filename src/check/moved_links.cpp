// Rule 1, `moved`: regions that overlap where they are moved, the more the farther apart they lie.
#include "check/partition.hpp"

namespace tetloft::internal::checking {

std::vector<Link> moved_links(const Regions& regions, const MovedRatios& m, double tau) {
  std::vector<Link> links;
  for (const Link& pair : m.pairs()) {
    const double moved = m(pair);
    if (!(moved > tau)) continue;
    // None farther apart than a gap: no ratio exceeds 1.
    const std::optional<double> d = regions.distance(pair, 1);
    if (d.has_value() && moved > tau + *d) links.push_back(pair);
  }
  return links;
}

}  // namespace tetloft::internal::checking
