// m of the rule: how far two regions overlap where they are moved
// (include/tetloft/correspondence.hpp).
#pragma once

#include <optional>

#include "correspondence/moved_region.hpp"
#include "correspondence/section_regions.hpp"
#include "motion/region_motions.hpp"

namespace tetloft::internal {

/// The regions of one slab where their motions bring them; without motions m is r.
class MovedPairs {
 public:
  /// Sections must outlive this. Empty motions: none.
  MovedPairs(const SectionRegions& below, const SectionRegions& above, const SlabMotions& motions);

  /// m.
  [[nodiscard]] double ratio(RegionId lower, RegionId upper) const;
  /// A box around where the region lies and where it is moved to.
  [[nodiscard]] const Box2& reach_of_lower(RegionId r) const { return lower_[r].reach; }
  [[nodiscard]] const Box2& reach_of_upper(RegionId r) const { return upper_[r].reach; }

 private:
  struct Place {
    bool moves = false;
    std::optional<MovedRegion> there;  // none where rounding leaves no region
    Box2 box;                          // there
    Box2 reach;
  };
  using Places = IdVector<RegionId, Place>;
  static Places places(const SectionRegions& section,
                       const IdVector<RegionId, std::optional<Point2>>& motions, double sign);
  const SectionRegions& below_;
  const SectionRegions& above_;
  Places lower_, upper_;
};

}  // namespace tetloft::internal
