// From the shapes of all classes to sections.
#pragma once

#include <vector>

#include "between/competition.hpp"
#include "between/inner_sections.hpp"

namespace tetloft::internal::between {

struct TracedShapes {
  /// None where trace_between() says so, and where classes are left in parts.
  InnerSections inner;
  std::vector<ClassId> left_apart;  ///< such classes, ascending
};

/// Traces the shapes, one for each class of the slab, and changes their layers between in doing so.
/// Parts of the classes `bridged`, ascending, that are left apart are bridged.
[[nodiscard]] TracedShapes trace_shapes(const SlabShape& slab, ClassShapes& shapes,
                                        const std::vector<ClassId>& bridged = {});

}  // namespace tetloft::internal::between
