// What the tets of a slab have in its sections, where the engine does not tell.
#pragma once

#include <tetloft/conforming_section.hpp>

#include "slab/delaunay.hpp"

namespace tetloft::internal {

/// A triangulation that is canonical already, with its bases, by search.
[[nodiscard]] SlabDelaunay with_bases(const ConformingSection& lower,
                                      const ConformingSection& upper, TetMesh mesh);

}  // namespace tetloft::internal
