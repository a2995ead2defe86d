// The regions of all sections of a stack in one numbering, by (section, region).
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/nesting.hpp>

#include "slab/link.hpp"
#include "slab/numbering.hpp"

namespace tetloft::internal {

using StackRegionId = Id<struct StackRegionTag>;

class StackRegions {
 public:
  explicit StackRegions(const IdVector<SectionId, Nesting>& nestings) {
    for (const Nesting& nesting : nestings) first_.push_back(first_.back() + nesting.outer.size());
  }
  [[nodiscard]] std::size_t size() const { return first_.back(); }
  [[nodiscard]] StackRegionId of(SectionId s, RegionId r) const {
    return StackRegionId(first_[s.index()] + r.index());
  }
  [[nodiscard]] StackRegionId below(const Link& l) const {
    return of(lower_section(l.slab), l.lower);
  }
  [[nodiscard]] StackRegionId above(const Link& l) const {
    return of(upper_section(l.slab), l.upper);
  }
  [[nodiscard]] std::pair<SectionId, RegionId> locate(StackRegionId r) const {
    const auto next = std::upper_bound(first_.begin(), first_.end(), r.index());
    const SectionId section(next - first_.begin() - 1);
    return {section, RegionId(r.index() - first_[section.index()])};
  }

 private:
  std::vector<std::size_t> first_{0};
};

}  // namespace tetloft::internal
