#include "correspondence/moved_region.hpp"

#include <utility>

#include "core/guard.hpp"

namespace tetloft::internal {

std::optional<MovedRegion> moved(const RegionOutline& region, const Point2& by) {
  Section section;
  for (const Contour* contour : region.contours) {
    Contour copy = *contour;
    for (Point2& p : copy.vertices) p = {p.x + by.x, p.y + by.y};
    section.contours.push_back(std::move(copy));
  }
  SectionStack alone;
  alone.sections.push_back(std::move(section));
  if (!accepted(validate(alone))) return std::nullopt;
  MovedRegion result{std::move(alone.sections[SectionId(0)]), {}};
  result.nesting = nest(result.section);
  const IdVector<RegionId, ContourId>& outer = result.nesting.outer;
  if (outer.size() != 1 || outer[RegionId(0)] != ContourId(0)) return std::nullopt;
  return result;
}

}  // namespace tetloft::internal
