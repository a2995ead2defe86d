// A boundary surface with vertices of its own.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/model.hpp>

namespace tetloft::internal::io {

struct SurfaceMesh {
  std::vector<Point3> points;  ///< those on the surface, in the model's order, placed by its frame
  std::vector<VertexId> vertex;                         ///< the model vertex of each point
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< outward
  std::vector<TetId> tet;                               ///< behind each triangle
};

[[nodiscard]] SurfaceMesh surface_mesh(const Model& model);

/// The surface of one component.
struct SurfacePart {
  std::size_t component = 0;  ///< from 0
  std::string name;
  std::vector<std::uint32_t> triangles;  ///< of the mesh, in its order
};

/// The components that have triangles, in their order. Of a model that has none all is one.
[[nodiscard]] std::vector<SurfacePart> surface_parts(const SurfaceMesh& mesh, const Model& model);

/// Whether there is nothing to say of the surface but its triangles: one part, without names,
/// unit or orientation.
[[nodiscard]] bool is_nameless(const Model& model, const std::vector<SurfacePart>& parts);

/// A part with numbers of its own.
struct PartMesh {
  std::vector<std::uint32_t> vertex;                    ///< of the mesh, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of these vertices
};
[[nodiscard]] PartMesh part_mesh(const SurfaceMesh& mesh, const SurfacePart& part);

}  // namespace tetloft::internal::io
