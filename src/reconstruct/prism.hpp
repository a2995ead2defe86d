// Ends of components: a region extruded from its section plane.
//
// A class without counterpart in the other plane, a section next to an empty one and the
// ends of a stack (on demand) end in a prism over the region: no lean, no spike.
#pragma once

#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

#include "reconstruct/truncation.hpp"

namespace tetloft {

/// The internal triangles of each region of a section.
[[nodiscard]] IdVector<RegionId, std::vector<TriangleId>> triangles_by_region(
    const ConformingSection& section);

/// The vertices of each region of a section, by id.
[[nodiscard]] IdVector<RegionId, std::vector<VertexId>> vertices_by_region(
    const ConformingSection& section);

/// Extrudes one region. Section vertex v is node first_base + v; the k-th of `vertices` has
/// its copy on the far side at node first_cap + k. Pieces are positive if the far side lies
/// above the plane (upwards) or below it.
void extrude(const ConformingSection& section, const std::vector<TriangleId>& triangles,
             const std::vector<VertexId>& vertices, SlabRegionId region, std::size_t first_base,
             std::size_t first_cap, bool upwards, std::vector<Piece>& pieces);

}  // namespace tetloft
