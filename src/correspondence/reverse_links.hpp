// Criterion `reverse` of correspondence: Definition 2 of the paper.
#pragma once

#include <vector>

#include "slab/link.hpp"
#include "slab/slab.hpp"

namespace tetloft::internal {

/// The links of one slab, sorted.
[[nodiscard]] std::vector<Link> reverse_links(SlabId id, const Slab& slab);

}  // namespace tetloft::internal
