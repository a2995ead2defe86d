#include "correspondence/reverse_links.hpp"

#include <algorithm>

#include "core/sort_distinct.hpp"

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
  sort_distinct(links);
  return links;
}

}  // namespace tetloft::internal
