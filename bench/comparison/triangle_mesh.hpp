// Closed triangulated surfaces, whatever they come from, and how solids of tets become such.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/model.hpp>

namespace tetloft::bench {

/// Triangles whose right-hand normals point out of the solid.
struct TriangleMesh {
  IdVector<VertexId, Point3> points;
  std::vector<TriangleVertices> triangles;
};

/// The boundary of the tets as a closed manifold: where the solid touches itself in a vertex or an
/// edge, the sheets are parted by doubling it, so that genus and surfaces are those of the
/// interior. Requires that no face belongs to more than two tets, on its two sides.
[[nodiscard]] TriangleMesh boundary_of(const TetMesh& mesh,
                                       const IdVector<VertexId, Point3>& points);

/// Volume enclosed, signed: that of the tets from a point amid the surface to its triangles.
[[nodiscard]] double enclosed_volume(const TriangleMesh& mesh);

/// Where a surface fails to be a closed manifold.
struct SurfaceFaults {
  std::size_t edges = 0;     ///< not of two triangles that run along it in opposite directions
  std::size_t vertices = 0;  ///< whose link is not one cycle
};
[[nodiscard]] SurfaceFaults faults_of(const TriangleMesh& mesh);

/// Pieces, cavities and handles of a solid.
struct Topology {
  long components = 0;
  long cavities = 0;
  long genus = 0;  ///< of all boundary surfaces
};
/// Of the solid within a closed manifold surface: surfaces with positive volume bound components,
/// the others cavities.
[[nodiscard]] Topology topology_of(const TriangleMesh& mesh);

}  // namespace tetloft::bench
