// Gluing: the solids of all slabs and ends become one model.
//
// Section vertices are shared, everything else is a slab's own: at a section plane two
// solids meet in exactly the region's triangles, so links that are discs on both sides
// glue to a disc or sphere.
#pragma once

#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/model.hpp>

#include "reconstruct/slab_solid.hpp"

namespace tetloft::internal {

/// A solid to be glued: the slab it counts to and its sections (invalid: none).
struct Part {
  SlabId slab;
  SectionId lower;
  SectionId upper;
  SlabSolid solid;
};

/// component[section][region].
using RegionComponents = IdVector<SectionId, IdVector<RegionId, ComponentId>>;

/// The model of all parts, from below; each is given up as soon as it is glued. Vertices are
/// numbered by section (canonical order in each), then constructed ones by part; those that no tet
/// uses are left out. The same at any number of threads.
[[nodiscard]] Model glue(const IdVector<SectionId, ConformingSection>& sections,
                         const RegionComponents& component, std::vector<Part> parts,
                         unsigned threads = 1);

}  // namespace tetloft::internal
