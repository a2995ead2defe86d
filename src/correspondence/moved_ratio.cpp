#include "correspondence/moved_ratio.hpp"

#include <algorithm>

#include "correspondence/overlap_links.hpp"

namespace tetloft::internal {

MovedPairs::MovedPairs(const SectionRegions& below, const SectionRegions& above,
                       const SlabMotions& motions)
    : below_(below),
      above_(above),
      lower_(places(below, motions.lower, 1)),
      upper_(places(above, motions.upper, -1)) {}

MovedPairs::Places MovedPairs::places(const SectionRegions& section,
                                      const IdVector<RegionId, std::optional<Point2>>& motions,
                                      double sign) {
  Places places(section.size());
  for (const RegionId r : section.ids()) {
    Place& place = places[r];
    place.box = place.reach = section.box[r];
    if (motions.empty() || !motions[r]) continue;
    place.moves = true;
    place.there = moved(section.outline[r], {sign * motions[r]->x, sign * motions[r]->y});
    if (!place.there) continue;
    place.box = Box2();
    for (const Point2& p : place.there->section.contours[ContourId(0)].vertices) place.box.add(p);
    place.reach.add(place.box);
  }
  return places;
}

template <class Ask>
bool MovedPairs::any(RegionId lower, RegionId upper, const Ask& ask) const {
  const Place& low = lower_[lower];
  const Place& high = upper_[upper];
  if ((!low.moves || !high.moves) && ask(below_.outline[lower], above_.outline[upper])) return true;
  if (low.there && low.box.meets(above_.box[upper]) &&
      ask(low.there->outline(), above_.outline[upper])) {
    return true;
  }
  return high.there && high.box.meets(below_.box[lower]) &&
         ask(below_.outline[lower], high.there->outline());
}

double MovedPairs::ratio(RegionId lower, RegionId upper) const {
  double largest = 0;
  any(lower, upper, [&](const RegionOutline& a, const RegionOutline& b) {
    largest = std::max(largest, overlap_ratio(a, b));
    return false;
  });
  return largest;
}

bool MovedPairs::exceeds(RegionId lower, RegionId upper, double bound) const {
  return any(lower, upper, [&](const RegionOutline& a, const RegionOutline& b) {
    return compare_overlap(a, b, bound) == Sign::positive;
  });
}

}  // namespace tetloft::internal
