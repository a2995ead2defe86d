// Sets of regions that know their label.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "core/union_find.hpp"
#include "correspondence/stack_regions.hpp"

namespace tetloft::internal {

using RegionLabels = IdVector<StackRegionId, std::optional<std::uint32_t>>;

class LabelledSets {
 public:
  explicit LabelledSets(RegionLabels labels) : sets_(labels.size()), label_(std::move(labels)) {}

  /// The least region of the set.
  [[nodiscard]] StackRegionId find(StackRegionId r) const {
    return StackRegionId(sets_.find(r.index()));
  }
  [[nodiscard]] const std::optional<std::uint32_t>& label(StackRegionId r) const {
    return label_[find(r)];
  }
  [[nodiscard]] bool may_unite(StackRegionId a, StackRegionId b) const {
    return !label(a) || !label(b) || *label(a) == *label(b);
  }
  void unite(StackRegionId a, StackRegionId b) {
    const auto joint = label(a) ? label(a) : label(b);
    sets_.unite(a.index(), b.index());
    label_[find(a)] = joint;
  }

 private:
  UnionFind sets_;
  RegionLabels label_;  // valid at representatives
};

}  // namespace tetloft::internal
