// From the shapes of all classes to sections.
#pragma once

#include <vector>

#include "between/competition.hpp"
#include "between/inner_sections.hpp"

namespace tetloft::internal::between {

/// Traces the shapes, one for each class of the slab, and changes their layers between in doing so.
struct TracedShapes {
  InnerSections inner;              ///< none where trace_between() says so, and where classes are
                                    ///< left in parts
  std::vector<ClassId> left_apart;  ///< such classes, ascending
};

[[nodiscard]] TracedShapes trace_shapes(const SlabShape& slab, ClassShapes& shapes);

}  // namespace tetloft::internal::between
