// Ends of components: a region extruded from its section plane.
//
// A class without counterpart in the other plane, a section next to an empty one and the
// ends of a stack (on demand) end in a prism over the region: no lean, no spike.
#pragma once

#include <vector>

#include <tetloft/conforming_section.hpp>
#include <tetloft/point.hpp>

#include "subdivision/truncation.hpp"

namespace tetloft::internal {

/// The internal triangles of each region of a section.
[[nodiscard]] IdVector<RegionId, std::vector<TriangleId>> triangles_by_region(
    const ConformingSection& section);

/// The vertices of each region of a section, by id.
[[nodiscard]] IdVector<RegionId, std::vector<PlaneVertexId>> vertices_by_region(
    const ConformingSection& section);

/// What a prism over a region is made of.
struct PrismNodes {
  SlabVertices slab;
  bool upper = false;  ///< the region's section is the slab's upper one
  Nodes nodes;
  CapId first_cap;  ///< the copy of the region's first vertex; the others follow
};

/// Extrudes one region from its section into the slab. Pieces are positive if the caps lie on the
/// slab's side of the section.
void extrude(const ConformingSection& section, const std::vector<TriangleId>& triangles,
             const std::vector<PlaneVertexId>& vertices, SlabRegionId region,
             const PrismNodes& prism, std::vector<Piece>& pieces);

}  // namespace tetloft::internal
