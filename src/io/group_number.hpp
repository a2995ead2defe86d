// Numbers of components at each tet, as files have them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/model.hpp>

#include "io/groups.hpp"

namespace tetloft::internal::io {

/// component_tag(); `of_none` of a tet that is of no component. Requires a well formed model.
[[nodiscard]] inline std::int64_t group_number(const Model& model, TetId tet,
                                               std::int64_t of_none = 0) {
  const ComponentId component = component_at(model, tet);
  return component.valid() ? component_tag(component) : of_none;
}

/// The place in component_groups(model) of the group of each tet.
[[nodiscard]] inline IdVector<TetId, std::size_t> group_places(
    const Model& model, const std::vector<ComponentGroup>& groups) {
  IdVector<TetId, std::size_t> places(model.tets.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const TetId t : groups[g].tets) places[t] = g;
  }
  return places;
}

/// For formats whose numbers are above 0: one that no group has.
[[nodiscard]] inline std::int64_t free_number(const std::vector<ComponentGroup>& groups) {
  std::int64_t largest = 0;
  for (const ComponentGroup& group : groups) largest = std::max(largest, group.tag());
  return largest + 1;
}

}  // namespace tetloft::internal::io
