#include "support/refine/refine_model.hpp"

#include <algorithm>
#include <vector>

#include <tetloft/predicates.hpp>

namespace tetloft::testing {

std::optional<VertexId> insert_vertex(Model& model, std::span<const VertexId> simplex,
                                      const Point3& p) {
  const VertexId added = model.points.push_back(p);
  std::vector<TetVertices> tets;
  for (const TetVertices& tet : model.tets) {
    const bool has_all = std::all_of(simplex.begin(), simplex.end(), [&](VertexId v) {
      return std::find(tet.begin(), tet.end(), v) != tet.end();
    });
    if (!has_all) {
      tets.push_back(tet);
      continue;
    }
    for (const VertexId v : simplex) {
      TetVertices part = tet;
      std::replace(part.begin(), part.end(), v, added);
      const auto at = [&](std::size_t i) -> const Point3& { return model.points[part[i]]; };
      if (orient3d(at(0), at(1), at(2), at(3)) != Sign::positive) {
        model.points.raw().pop_back();
        return std::nullopt;
      }
      tets.push_back(part);
    }
  }
  model.tets.raw() = std::move(tets);
  return added;
}

}  // namespace tetloft::testing
