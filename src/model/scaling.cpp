#include "model/scaling.hpp"

#include <algorithm>

#include "core/unit_of_length.hpp"

namespace tetloft::internal {

bool scale_exactly(Model& model, int exponent) {
  const bool exact = std::all_of(model.points.begin(), model.points.end(),
                                 [&](const Point3& p) { return is_scaled_exactly(p, exponent); });
  if (!exact) return false;
  for (const RegionMotion& motion : model.motions) {
    if (!is_scaled_exactly(motion.by, exponent)) return false;
  }
  for (Point3& p : model.points) p = scaled(p, exponent);
  for (RegionMotion& motion : model.motions) motion.by = scaled(motion.by, exponent);
  return true;
}

}  // namespace tetloft::internal
