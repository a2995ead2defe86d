// D: the 3D Delaunay triangulation of a slab's vertices.
#pragma once

#include <array>

#include <tetloft/conforming_section.hpp>
#include <tetloft/delaunay3.hpp>
#include <tetloft/result.hpp>
#include <tetloft/tet_mesh.hpp>

#include "delaunay3/slab_overlay.hpp"

namespace tetloft::internal {

using delaunay3_detail::TetBase;

/// By triangle of a section: the edges opposite its vertices.
using EdgesOfSides = IdVector<TriangleId, std::array<EdgeId, 3>>;

/// D of a slab: canonical tets over the points of both planes, lower first.
struct SlabDelaunay {
  TetMesh mesh;
  IdVector<TetId, TetBase> base;      ///< what each tet has in the triangulations of the planes
  std::array<EdgesOfSides, 2> edges;  ///< of the lower plane, of the upper one
};

/// Fails (work_limit) naming the slab, where D has more tets than `work_limit` allows
/// (ReconstructOptions).
[[nodiscard]] Result<SlabDelaunay> slab_delaunay(SlabId id, const ConformingSection& lower,
                                                 const ConformingSection& upper,
                                                 DelaunayEngine engine, double work_limit);

}  // namespace tetloft::internal
