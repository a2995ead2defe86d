// A boundary surface with vertices of its own.
#pragma once

#include <array>
#include <cstdint>
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

}  // namespace tetloft::internal::io
