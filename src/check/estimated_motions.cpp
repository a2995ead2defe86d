// Motions found anew: whether those of a model are the ones that its sections give.
#include <utility>

#include "check/motions.hpp"
#include "motion/region_motions.hpp"

namespace tetloft::internal::checking {

Motions estimated_motions(const SectionStack& stack, const Regions& regions) {
  std::vector<WantedRegions> wanted(regions.section_count());
  for (const Passage& passage : moving_passages(regions)) {
    const std::size_t s = regions.section[passage.region];
    WantedRegions& of_slab = wanted[passage.up ? s : s - 1];
    (passage.up ? of_slab.lower : of_slab.upper).emplace_back(passage.region - regions.first[s]);
  }
  const IdVector<SectionId, Nesting> nestings(regions.nesting);
  Motions motions;
  for (std::size_t slab = 0; slab + 1 < regions.section_count(); ++slab) {
    if (wanted[slab].lower.empty() && wanted[slab].upper.empty()) continue;
    const SlabMotions of_slab = estimate_motions(SlabId(slab), stack, nestings, wanted[slab]);
    const auto take = [&](const IdVector<RegionId, std::optional<Point2>>& estimates,
                          std::size_t section) {
      for (const RegionId r : estimates.ids()) {
        const std::optional<Point2>& by = estimates[r];
        if (!by.has_value() || *by == Point2{0, 0}) continue;
        motions.emplace(Passage{regions.first[section] + r.index(), section == slab}, *by);
      }
    };
    take(of_slab.lower, slab);
    take(of_slab.upper, slab + 1);
  }
  return motions;
}

}  // namespace tetloft::internal::checking
