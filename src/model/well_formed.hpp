// Whether a model's arrays fit each other, asked before they are indexed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <tetloft/model.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal {

/// A model, or mesh, holds fewer tets than this: half-faces have 32 bits.
inline constexpr std::size_t kMostModelTets = std::size_t{1} << 30;

/// invalid_input at kMostModelTets or more, and where a tet names a vertex that there is not.
[[nodiscard]] Result<void> check_tets(std::size_t vertex_count, std::span<const TetVertices> tets);

/// Are all four vertices of the tet there?
[[nodiscard]] inline bool is_sound(const Model& model, const TetVertices& tet) {
  return std::all_of(tet.begin(), tet.end(),
                     [&](VertexId v) { return v.index() < model.points.size(); });
}

/// As check_tets(); and where an array of the model has neither no values nor one for each tet or
/// point, or a kind or origin that there is none of; or a link, motion or deviation without a slab,
/// or without a contour (of a link of voids: an exterior's has none), of no evidence or fate, or
/// with a number that is not finite.
[[nodiscard]] Result<void> check_well_formed(const Model& model);

}  // namespace tetloft::internal
