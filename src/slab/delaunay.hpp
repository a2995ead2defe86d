// D: the 3D Delaunay triangulation of a slab's vertices.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal {

/// D of a slab: canonical tets over the points of both planes, lower first. Fails (work_limit)
/// naming the slab, where it has more tets than `work_limit` allows (ReconstructOptions).
[[nodiscard]] Result<TetMesh> slab_delaunay(SlabId id, const ConformingSection& lower,
                                            const ConformingSection& upper, DelaunayEngine engine,
                                            double work_limit);

}  // namespace tetloft::internal
