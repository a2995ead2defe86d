// What a solid leaves of the sections it was made from.
#pragma once

#include <cstddef>

#include <tetloft/sections.hpp>

#include "comparison/nearest.hpp"
#include "comparison/triangle_mesh.hpp"

namespace tetloft::bench {

/// The area of the symmetric difference between the solid's cut with each section's plane and the
/// section's region, summed over the sections, over the sum of the regions' areas. A solid is
/// closed: its cut is what it is just above the plane or just below it. Areas by lines along x,
/// `lines` to a section, exact in each.
[[nodiscard]] double section_deviation(const TriangleMesh& surface, const SectionStack& stack,
                                       std::size_t lines = 256);

/// Contours of which no vertex lies within `tolerance` of the surface.
[[nodiscard]] std::size_t lost_contours(const SurfaceSearch& surface, const SectionStack& stack,
                                        double tolerance);

}  // namespace tetloft::bench
