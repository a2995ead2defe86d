// The tets of two planes' overlay in canonical numbering.
//
// Canonical order is that of the tets' sorted vertices, lower ones first. The edges of a section
// are numbered in that order, too, so that it comes from theirs: at each lower vertex, by its edges
// to higher ones, the type-1 tets on triangles with no lower edge than this, by their third vertex,
// and the type-2 tets on it, by their upper edge; then the type-1 tets below whose apex it is.
#pragma once

#include <tetloft/conforming_section.hpp>

#include "slab/delaunay.hpp"

namespace tetloft::internal {

/// As canonical_mesh() has it (delaunay3/canonical_mesh.hpp). Linear.
[[nodiscard]] SlabDelaunay canonical_slab(const ConformingSection& lower,
                                          const ConformingSection& upper,
                                          const delaunay3_detail::SlabTets& tets);

/// A triangulation that is canonical already, with its bases, by search.
[[nodiscard]] SlabDelaunay with_bases(const ConformingSection& lower,
                                      const ConformingSection& upper, TetMesh mesh);

}  // namespace tetloft::internal
