// Stacks as GeoJSON.
#pragma once

#include "io/format.hpp"

namespace tetloft::internal::io {

/// Each region a Polygon with its holes, its height as property "z"; outer contours run
/// counter-clockwise and holes clockwise, as RFC 7946 asks, from the vertex that they begin with.
/// Sections without contours are left out, with a warning. The stack must be valid.
[[nodiscard]] Written write_geojson(Sink& sink, const SectionStack& stack, const Target& target);

}  // namespace tetloft::internal::io
