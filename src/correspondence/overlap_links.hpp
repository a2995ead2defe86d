// Criterion `overlap` of correspondence, guarded.
#pragma once

#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/nesting.hpp>

#include "slab/link.hpp"

namespace tetloft::internal {

/// The links of one slab, sorted.
[[nodiscard]] std::vector<Link> overlap_links(SlabId slab, const Section& below,
                                              const Nesting& nesting_below, const Section& above,
                                              const Nesting& nesting_above, double tau);

}  // namespace tetloft::internal
