// Signed distances by their definition in src/motion/README.md, edge by edge: slow, and equal to
// the product's bit by bit.
#pragma once

#include <tetloft/point.hpp>
#include <tetloft/section_stack.hpp>

namespace tetloft::testing {

/// At a place in lattice units, to all edges of the section; no farther than `farthest`.
[[nodiscard]] double distance_by_all_edges(const Section& section, double step, const Point2& at,
                                           double farthest);

}  // namespace tetloft::testing
