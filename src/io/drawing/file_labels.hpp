// Labels and adjacency of a file as labels of the stack that was made of it.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/correspondence.hpp>
#include <tetloft/section_stack.hpp>

#include "io/drawing/choose_lines.hpp"

namespace tetloft::internal::io {

/// By section and contour: the line that it was.
using LineOfContour = std::vector<std::vector<std::size_t>>;

/// The lines' labels, of outer contours: those of holes belong to the same regions. Requires a
/// valid stack, and labels of 32 bits.
[[nodiscard]] Labels labels_of_lines(const LineOfContour& origin,
                                     const std::vector<ChosenLine>& lines,
                                     const SectionStack& stack);

/// Contours that hang together by joins get one label, numbered from 1 in the order of contours:
/// outer contours as such, holes as holes. Requires a valid stack.
[[nodiscard]] Labels labels_of_joins(const LineOfContour& origin,
                                     const std::vector<ChosenLine>& lines,
                                     const std::vector<DrawnJoin>& joins,
                                     const SectionStack& stack);

}  // namespace tetloft::internal::io
