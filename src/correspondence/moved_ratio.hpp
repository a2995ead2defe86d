// m of the rule: how far two regions overlap where they are moved
// (include/tetloft/correspondence.hpp).
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "correspondence/moved_region.hpp"
#include "correspondence/section_regions.hpp"
#include "motion/region_motions.hpp"

namespace tetloft::internal {

/// The regions of one slab where their motions bring them; without motions m is r.
class MovedPairs {
 public:
  /// Sections must outlive this. Empty motions: none.
  MovedPairs(const SectionRegions& below, const SectionRegions& above, const SlabMotions& motions);

  /// m of a pair with this overlap ratio r.
  [[nodiscard]] double ratio(RegionId lower, RegionId upper, double r) const;
  /// The pairs that may overlap where one of the two is moved, sorted.
  [[nodiscard]] std::vector<std::pair<RegionId, RegionId>> near_where_moved() const;

 private:
  struct Place {
    bool moves = false;
    std::optional<MovedRegion> there;  // none where rounding leaves no region
    Box2 box;                          // there
  };
  using Places = IdVector<RegionId, Place>;
  static Places places(const SectionRegions& section,
                       const IdVector<RegionId, std::optional<Point2>>& motions, double sign);
  const SectionRegions& below_;
  const SectionRegions& above_;
  Places lower_, upper_;
};

}  // namespace tetloft::internal
