// Components of a stack whose sections come one after the other, from below: those of
// decide_correspondence(), in the memory of a section and a number for each region that nothing
// below is linked to.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/nesting.hpp>

#include "core/union_find.hpp"
#include "reconstruct/section_plan.hpp"
#include "slab/link.hpp"

namespace tetloft::internal {

class RisingComponents {
 public:
  /// The components of the next section, by numbers for the time being. `links`: accepted ones of
  /// the slab below it; none of the first section.
  [[nodiscard]] SectionComponents add(const Nesting& nesting, const std::vector<Link>& links);

  /// What each number for the time being stands for, once all sections are there: components in
  /// order of their first contour by (section, contour).
  [[nodiscard]] IdVector<ComponentId, ComponentId> numbers() const;

 private:
  UnionFind sets_{0};
  IdVector<RegionId, ComponentId> below_;  // of the section added last
};

/// Replaces numbers by those.
void renumber(SectionComponents& components, const IdVector<ComponentId, ComponentId>& numbers);

}  // namespace tetloft::internal
