// Refines models as meshers do: by vertices inserted into edges, faces and tets.
#pragma once

#include <optional>
#include <span>

#include <tetloft/model.hpp>

namespace tetloft::testing {

/// Inserts a vertex at p into an edge, a face or a tet of a model, given by its vertices: all tets
/// that have it are split. Where a tet would not be positive (p is rounded) nothing is changed.
/// Points and tets only: other arrays of the model are left as they are.
std::optional<VertexId> insert_vertex(Model& model, std::span<const VertexId> simplex,
                                      const Point3& p);

}  // namespace tetloft::testing
