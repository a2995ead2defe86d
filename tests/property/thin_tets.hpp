// Where doubles have no room: tets about as thin as their spacing.
#pragma once

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::testing {

/// Does D of the slab have a tet that is less than 2^12 units in the last place of the largest
/// coordinate thick, and has its corner at `place`, or an edge in one plane with its middle near it
/// (as seen along z)? The midpoint, lifted, and cuts near the corner must split that tet into
/// positive ones.
[[nodiscard]] bool has_thin_tet(const SectionStack& stack, std::size_t slab, const Point3& place);

}  // namespace tetloft::testing
