// Step 1 of Geiger's algorithm: feet of obtuse corners on contour edges.
#pragma once

#include <tetloft/conforming_section.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::geiger {

/// The section with a vertex on every contour edge below an obtuse corner of an internal
/// triangle, and with the vertices that conforming inserts. Feet are rounded once; where they
/// would make contours touch, the rounds end before. `feet` counts them.
[[nodiscard]] Result<Section> with_feet(const Section& section, SectionId id, std::size_t& feet);

}  // namespace tetloft::internal::geiger
