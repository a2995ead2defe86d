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
  ComponentId component;                 ///< invalid: of tets that are of none
  std::string name;                      ///< group_name()
  std::vector<std::uint32_t> triangles;  ///< of the mesh, in its order
};

/// The components that have triangles, in their order, what is of none last.
[[nodiscard]] std::vector<SurfacePart> surface_parts(const SurfaceMesh& mesh, const Model& model);

/// Whether there is nothing to say of the surface but its triangles: one part, without names,
/// unit or orientation.
[[nodiscard]] bool is_nameless(const Model& model, const std::vector<SurfacePart>& parts);

/// How many edges of a part are not those of one triangle on either side.
[[nodiscard]] std::size_t unmatched_edges(const SurfaceMesh& mesh, const SurfacePart& part);

/// The triangles of all parts, one part after the other.
[[nodiscard]] std::vector<std::uint32_t> by_part(const std::vector<SurfacePart>& parts);

/// What a file tells in comments whose triangles are by_part(): name, unit, orientation, and how
/// many triangles each component has; of a nameless one nothing. Each in one line.
[[nodiscard]] std::vector<std::string> surface_comments(const Model& model,
                                                        const std::vector<SurfacePart>& parts);

/// A part with numbers of its own.
struct PartMesh {
  std::vector<std::uint32_t> vertex;                    ///< of the mesh, ascending
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of these vertices
};
[[nodiscard]] PartMesh part_mesh(const SurfaceMesh& mesh, const SurfacePart& part);

}  // namespace tetloft::internal::io
