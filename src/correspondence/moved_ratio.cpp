#include "correspondence/moved_ratio.hpp"

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

double MovedPairs::ratio(RegionId lower, RegionId upper) const {
  const Place& low = lower_[lower];
  const Place& high = upper_[upper];
  const bool all_move = low.moves && high.moves;
  const double still = all_move ? 0 : overlap_ratio(below_.outline[lower], above_.outline[upper]);
  const auto of = [&](const Place& place, const RegionOutline& other, const Box2& box) {
    if (!place.moves) return still;
    const bool meets = place.there && place.box.meets(box);
    return meets ? overlap_ratio(place.there->outline(), other) : 0.0;
  };
  return (of(low, above_.outline[upper], above_.box[upper]) +
          of(high, below_.outline[lower], below_.box[lower])) /
         2;
}

}  // namespace tetloft::internal
