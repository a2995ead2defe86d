#include "model/well_formed.hpp"

#include <string>
#include <tuple>

#include "core/enums.hpp"

namespace tetloft {

namespace {

Error refusal(std::string message) { return {ErrorCode::invalid_input, std::move(message), {}}; }

// The first value that is no enumerator.
template <class Ids, class Enum>
Result<void> check_values(const IdVector<Ids, Enum>& values, Enum last, const char* owner,
                          const char* what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Enum value = values[Ids(i)];
    if (is_enumerator(value, last)) continue;
    return refusal(std::string(owner) + ' ' + std::to_string(i) + " has the " + what + ' ' +
                   std::to_string(static_cast<int>(value)) + ", which there is not");
  }
  return {};
}

Result<void> check_sizes(const Model& model) {
  const std::size_t points = model.points.size();
  const std::size_t tets = model.tets.size();
  for (const auto& [name, size, expected] :
       {std::tuple{"component", model.component.size(), tets},
        std::tuple{"slab", model.slab.size(), tets}, std::tuple{"kind", model.kind.size(), tets},
        std::tuple{"section", model.section.size(), points},
        std::tuple{"contour", model.contour.size(), points},
        std::tuple{"origin", model.origin.size(), points}}) {
    if (size == 0 || size == expected) continue;
    return refusal(std::string("the model's array ") + name + " has " + std::to_string(size) +
                   " values where " + std::to_string(expected) + " are due");
  }
  return {};
}

}  // namespace

Result<void> check_tets(std::size_t vertex_count, std::span<const TetVertices> tets) {
  if (tets.size() >= kMostModelTets) return refusal("2^30 tets or more");
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (const VertexId v : tets[t]) {
      if (v.index() < vertex_count) continue;
      return refusal("tet " + std::to_string(t) + " names vertex " + std::to_string(v.value()) +
                     " of " + std::to_string(vertex_count));
    }
  }
  return {};
}

Result<void> check_well_formed(const Model& model) {
  Result<void> fine = check_tets(model.points.size(), model.tets.raw());
  if (fine) fine = check_sizes(model);
  if (fine) fine = check_values(model.kind, TetKind::prism, "tet", "kind");
  if (fine) fine = check_values(model.origin, PointOrigin::projected, "vertex", "origin");
  return fine;
}

}  // namespace tetloft
