#include "reconstruct/ends.hpp"

#include <algorithm>
#include <cmath>

namespace tetloft::internal {

double single_thickness(const PreparedStack& prepared, const ReconstructOptions& options,
                        std::vector<Warning>& warnings) {
  if (options.thickness) return std::ldexp(*options.thickness, prepared.exponent);
  Point2 low{};
  Point2 high{};
  bool first = true;
  for (const Contour& contour : prepared.stack.sections[SectionId(0)].contours) {
    for (const Point2& p : contour.vertices) {
      low = first ? p : Point2{std::min(low.x, p.x), std::min(low.y, p.y)};
      high = first ? p : Point2{std::max(high.x, p.x), std::max(high.y, p.y)};
      first = false;
    }
  }
  if (first) return 1;  // nothing to extrude
  Place place;
  place.section = 0;
  warnings.push_back(
      {"a single section has no thickness of its own: a tenth of its "
       "larger side is taken; give one to be sure",
       place});
  return std::max(high.x - low.x, high.y - low.y) / 10;
}

Result<EndPlanes> place_ends(const std::vector<double>& heights, Ends wanted,
                             double thickness_of_single) {
  const std::size_t sections = heights.size();
  const double first = heights.front();
  const double last = heights.back();
  EndPlanes ends;
  if (sections == 1) {
    const double half = 0.5 * thickness_of_single;
    ends = {first - half, last + half};
  } else if (wanted == Ends::half) {
    ends = {first - 0.5 * (heights[1] - first), last + 0.5 * (last - heights[sections - 2])};
  } else {
    return ends;
  }
  if (!(*ends.below < first) || !(*ends.above > last)) {
    Place place;
    place.section = *ends.below < first ? sections - 1 : 0;
    return Error{ErrorCode::unrepresentable,
                 "the end is too thin for a double beside the section's z", place};
  }
  return ends;
}

}  // namespace tetloft::internal
