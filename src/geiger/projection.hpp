// Step 2 of Geiger's algorithm: external skeletons projected into the neighbouring regions.
#pragma once

#include <span>
#include <vector>

#include <tetloft/conforming_section.hpp>

namespace tetloft::internal::geiger {

/// The vertices of the external skeleton: circumcentres of external triangles.
[[nodiscard]] std::vector<Point2> external_skeleton_vertices(const ConformingSection& section);

/// Those of `candidates` that lie inside the region of `section`, each at least a tenth of the
/// mean contour edge away from contours and from each other; of near ones the lowest is kept.
/// Sorted canonically.
[[nodiscard]] std::vector<Point2> projected_into(const ConformingSection& section,
                                                 std::span<const Point2> candidates);

}  // namespace tetloft::internal::geiger
