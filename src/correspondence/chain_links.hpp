// Candidates of criterion `overlap` with `drift`: rule 1 of include/tetloft/correspondence.hpp.
#pragma once

#include <vector>

#include <tetloft/nesting.hpp>

#include "slab/link.hpp"

namespace tetloft::internal {

/// The further candidates of one slab, sorted. overlap[slab]: the links by overlap alone, of
/// all slabs; only this slab's and those of the slabs beside it are looked at.
[[nodiscard]] std::vector<Link> drift_links(SlabId slab, const SectionStack& stack,
                                            const IdVector<SectionId, Nesting>& nestings,
                                            const IdVector<SlabId, std::vector<Link>>& overlap,
                                            double drift);

}  // namespace tetloft::internal
