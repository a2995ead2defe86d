#include "io/surface.hpp"

#include <utility>

namespace tetloft::internal::io {

SurfaceMesh surface_mesh(const Model& model) {
  Surface surface = boundary_surface(model);
  SurfaceMesh mesh;
  mesh.tet = std::move(surface.tet);
  // New number of each model vertex; 0 of those that are not on the surface.
  IdVector<VertexId, std::uint32_t> number(model.points.size(), 0);
  for (const TriangleVertices& triangle : surface.triangles) {
    for (const VertexId v : triangle) number[v] = 1;
  }
  for (const VertexId v : model.points.ids()) {
    if (number[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(mesh.vertex.size());
    mesh.vertex.push_back(v);
    mesh.points.push_back(place(model.frame, model.points[v]));
  }
  mesh.triangles.reserve(surface.triangles.size());
  for (const TriangleVertices& t : surface.triangles) {
    mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return mesh;
}

}  // namespace tetloft::internal::io
