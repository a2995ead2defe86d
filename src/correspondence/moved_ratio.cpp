#include "correspondence/moved_ratio.hpp"

#include "core/sort_distinct.hpp"

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
    if (motions.empty() || !motions[r]) continue;
    place.moves = true;
    place.there = moved(section.outline[r], {sign * motions[r]->x, sign * motions[r]->y});
    if (!place.there) continue;
    for (const Point2& p : place.there->section.contours[ContourId(0)].vertices) place.box.add(p);
  }
  return places;
}

double MovedPairs::ratio(RegionId lower, RegionId upper, double r) const {
  const auto of = [r](const Place& place, const RegionOutline& other, const Box2& box) {
    if (!place.moves) return r;
    const bool meets = place.there && place.box.meets(box);
    return meets ? overlap_ratio(place.there->outline(), other) : 0.0;
  };
  return (of(lower_[lower], above_.outline[upper], above_.box[upper]) +
          of(upper_[upper], below_.outline[lower], below_.box[lower])) /
         2;
}

std::vector<std::pair<RegionId, RegionId>> MovedPairs::near_where_moved() const {
  std::vector<std::pair<RegionId, RegionId>> pairs;
  for (const RegionId i : lower_.ids()) {
    if (!lower_[i].there) continue;
    above_.for_each_near(lower_[i].box, [&](RegionId j) { pairs.emplace_back(i, j); });
  }
  for (const RegionId j : upper_.ids()) {
    if (!upper_[j].there) continue;
    below_.for_each_near(upper_[j].box, [&](RegionId i) { pairs.emplace_back(i, j); });
  }
  sort_distinct(pairs);
  return pairs;
}

}  // namespace tetloft::internal
