#include "io/surface.hpp"

#include <algorithm>
#include <numeric>
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

std::vector<SurfacePart> surface_parts(const SurfaceMesh& mesh, const Model& model) {
  const auto component_of = [&](std::uint32_t triangle) {
    return model.component.empty() ? ComponentId(0) : model.component[mesh.tet[triangle]];
  };
  std::vector<std::uint32_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return component_of(i) < component_of(j);
  });
  std::vector<SurfacePart> parts;
  for (const std::uint32_t triangle : order) {
    const ComponentId component = component_of(triangle);
    if (parts.empty() || parts.back().component != component.index()) {
      parts.push_back({component.index(), component_name(model, component), {}});
    }
    parts.back().triangles.push_back(triangle);
  }
  return parts;
}

bool is_nameless(const Model& model, const std::vector<SurfacePart>& parts) {
  return parts.size() <= 1 && model.about == Description() && model.component_names.empty();
}

PartMesh part_mesh(const SurfaceMesh& mesh, const SurfacePart& part) {
  PartMesh own;
  for (const std::uint32_t triangle : part.triangles) {
    const auto& corners = mesh.triangles[triangle];
    own.vertex.insert(own.vertex.end(), corners.begin(), corners.end());
  }
  std::sort(own.vertex.begin(), own.vertex.end());
  own.vertex.erase(std::unique(own.vertex.begin(), own.vertex.end()), own.vertex.end());
  own.triangles.reserve(part.triangles.size());
  for (const std::uint32_t triangle : part.triangles) {
    std::array<std::uint32_t, 3> corners = mesh.triangles[triangle];
    for (std::uint32_t& v : corners) {
      v = static_cast<std::uint32_t>(
          std::lower_bound(own.vertex.begin(), own.vertex.end(), v) - own.vertex.begin());
    }
    own.triangles.push_back(corners);
  }
  return own;
}

}  // namespace tetloft::internal::io
