// Stacks of leaning rods, and what they should do.
#pragma once

#include <cstdint>
#include <vector>

#include <tetloft/nesting.hpp>
#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

#include "motion/region_motions.hpp"

namespace tetloft::testing {

/// An octagon, regular to three digits, from numbers that every machine has alike.
[[nodiscard]] Contour octagon(const Point2& centre, double radius);

/// Rods through the centres at height 0, all leaning alike by unit of height, at these heights.
[[nodiscard]] SectionStack leaning_rods(const std::vector<Point2>& centres, double radius,
                                        const Point2& lean, const std::vector<double>& heights);

/// Irregular polygons in disjoint cells, `sections` of them, each a changed copy of the one below.
[[nodiscard]] SectionStack drifting_polygons(std::uint64_t seed, std::size_t sections);

[[nodiscard]] IdVector<SectionId, Nesting> nestings_of(const SectionStack& stack);

/// The motions of all regions of a slab.
[[nodiscard]] internal::SlabMotions all_motions(const SectionStack& stack, std::size_t slab);

}  // namespace tetloft::testing
