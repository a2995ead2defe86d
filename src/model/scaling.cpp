#include "model/scaling.hpp"

#include <algorithm>

#include "core/unit_of_length.hpp"

namespace tetloft::internal {

bool scale_exactly(Model& model, int exponent) {
  const bool exact = std::all_of(model.points.begin(), model.points.end(),
                                 [&](const Point3& p) { return is_scaled_exactly(p, exponent); });
  if (!exact) return false;
  for (Point3& p : model.points) p = scaled(p, exponent);
  return true;
}

}  // namespace tetloft::internal
