// The solid of a slab that has sections put between its two: the solids of the slabs between them,
// glued. Taken only where it has what was decided about the slab, as its two sections alone imply
// it; else the slab is built without.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/reconstruct.hpp>
#include <tetloft/result.hpp>

#include "between/inner_sections.hpp"
#include "reconstruct/slab_solid.hpp"

namespace tetloft::internal {

/// As build_slab(), with the sections between, which may be none. The solid with them is taken if
/// (1) all slabs between can be built; (2) regions hang together in it, and voids do, as the links
/// say; (3) its topology is as implied, or no farther from it than that of the solid without.
[[nodiscard]] Result<SlabOutcome> build_slab_between(SlabId id, const ConformingSection& lower,
                                                     const ConformingSection& upper,
                                                     const SlabLinks& links,
                                                     const between::InnerSections& inner,
                                                     const SlabOptions& options);

}  // namespace tetloft::internal
