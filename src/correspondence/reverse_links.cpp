#include "correspondence/reverse_links.hpp"

#include <algorithm>

namespace tetloft::internal {

std::vector<Link> reverse_links(SlabId id, const Slab& slab) {
  std::vector<Link> links;
  for (const TetId t : slab.tets()) {
    if (slab.kind(t) != TetKind::ii && slab.kind(t) != TetKind::ie) continue;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const SlabVertexId low = slab.vertex(t, i);
        const SlabVertexId high = slab.vertex(t, j);
        if (slab.is_upper(low) || !slab.is_upper(high)) continue;
        links.push_back({id, slab.lower().region[slab.in_section(low)],
                         slab.upper().region[slab.in_section(high)]});
      }
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

}  // namespace tetloft::internal
