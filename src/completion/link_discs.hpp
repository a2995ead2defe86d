// At which vertices the kept tets are a disc in the link: most are, and need no completion.
#pragma once

#include <cstdint>

#include "completion/complex.hpp"
#include "slab/slab.hpp"

namespace tetloft::internal {

/// By vertex, whether the tets kept there are a disc in its link; 0 where none are. In one sweep
/// over the kept tets.
[[nodiscard]] IdVector<SlabVertexId, std::uint8_t> link_discs(
    const Slab& slab, const IdVector<TetId, std::uint8_t>& kept);

}  // namespace tetloft::internal
