// Equality of models, bit by bit.
#pragma once

#include <tetloft/model.hpp>

#include "support/same_rows.hpp"

namespace tetloft::testing {

/// True iff all arrays are equal, -0.0 and 0.0 being different coordinates.
[[nodiscard]] inline bool same_bits(const Model& a, const Model& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Point3& p = a.points[VertexId(i)];
    const Point3& q = b.points[VertexId(i)];
    if (!test::same_number(p.x, q.x) || !test::same_number(p.y, q.y) ||
        !test::same_number(p.z, q.z))
      return false;
  }
  return a.tets == b.tets && a.component == b.component && a.slab == b.slab && a.kind == b.kind &&
         a.section == b.section && a.contour == b.contour && a.origin == b.origin &&
         a.component_count == b.component_count && test::same_rows(a.links, b.links) &&
         test::same_rows(a.motions, b.motions) && test::same_rows(a.void_links, b.void_links) &&
         test::same_rows(a.deviations, b.deviations);
}

}  // namespace tetloft::testing
