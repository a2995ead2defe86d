#include "between/class_shape.hpp"

namespace tetloft::internal::between {

ClassShape interpolate(const ClassOutlines& /*outlines*/, double /*step*/,
                       const std::vector<double>& /*at*/, const std::optional<Point2>& /*rigid*/) {
  return {};
}

}  // namespace tetloft::internal::between
