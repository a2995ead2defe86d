// D: the 3D Delaunay triangulation of a slab's vertices.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/slab_overlay.hpp"

namespace tetloft::internal {

using delaunay3_detail::EdgesOfSides;
using delaunay3_detail::TetBase;

/// D of a slab: canonical tets over the points of both planes, lower first. Edges are numbered as
/// those of the sections.
using SlabDelaunay = delaunay3_detail::SlabTets;

/// Fails (work_limit) naming the slab, where D has more tets than `work_limit` allows
/// (ReconstructOptions).
[[nodiscard]] Result<SlabDelaunay> slab_delaunay(SlabId id, const ConformingSection& lower,
                                                 const ConformingSection& upper,
                                                 DelaunayEngine engine, double work_limit);

}  // namespace tetloft::internal
