#include "correspondence/moved_region.hpp"

#include <cmath>
#include <utility>

#include <tetloft/nesting.hpp>

#include "core/guard.hpp"

namespace tetloft::internal {

namespace {

// Far below what validate() refuses.
constexpr double kSurelyLegal = 0x1p900;

// Is a + b the sum itself? As of lattices of few bits.
bool adds_exactly(double a, double b) {
  const double sum = a + b;
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b) == 0 && std::abs(sum) < kSurelyLegal;
}

// Valid, and all contours but the first its holes?
bool is_one_region(const Section& section) {
  SectionStack alone;
  alone.sections.push_back(section);
  if (!accepted(validate(alone))) return false;
  const IdVector<RegionId, ContourId> outer = nest(section).outer;
  return outer.size() == 1 && outer[RegionId(0)] == ContourId(0);
}

}  // namespace

RegionOutline MovedRegion::outline() const {
  RegionOutline outline;
  for (const Contour& contour : section.contours) outline.contours.push_back(&contour);
  return outline;
}

std::optional<MovedRegion> moved(const RegionOutline& region, const Point2& by) {
  MovedRegion result;
  bool rigid = true;
  for (const Contour* contour : region.contours) {
    Contour copy = *contour;
    for (Point2& p : copy.vertices) {
      rigid = rigid && adds_exactly(p.x, by.x) && adds_exactly(p.y, by.y);
      p = {p.x + by.x, p.y + by.y};
    }
    result.section.contours.push_back(std::move(copy));
  }
  // What is moved without any rounding is what it was.
  if (!rigid && !is_one_region(result.section)) return std::nullopt;
  return result;
}

}  // namespace tetloft::internal
