#include "check/shifted_region.hpp"

#include <utility>

#include "check/regions.hpp"
#include "core/guard.hpp"

namespace tetloft::internal::checking {

RegionOutline ShiftedRegion::shape() const {
  RegionOutline shape;
  for (const Contour& contour : section.contours) shape.contours.push_back(&contour);
  return shape;
}

std::optional<ShiftedRegion> shifted(const RegionOutline& region, const Point2& d) {
  SectionStack stack;
  Section& section = stack.sections.raw().emplace_back();
  for (const Contour* contour : region.contours) {
    Contour there;
    for (const Point2& p : contour->vertices) there.vertices.push_back({p.x + d.x, p.y + d.y});
    section.contours.push_back(std::move(there));
  }
  if (!accepted(validate(stack))) return std::nullopt;
  // The first contour with holes in it, all others.
  const Nesting nesting = nest(section);
  if (nesting.outer.size() != 1 || nesting.outer[RegionId(0)].index() != 0) return std::nullopt;
  const Box2 box = bounding_box(section.contours[ContourId(0)]);
  return ShiftedRegion{std::move(section), box};
}

}  // namespace tetloft::internal::checking
