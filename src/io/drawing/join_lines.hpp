// Open lines that are one line in pieces.
#pragma once

#include <cstddef>
#include <vector>

#include "io/drawing/drawing.hpp"

namespace tetloft::internal::io {

/// Joins open lines where the ends of two of them, and of no third, are the same point, exactly;
/// what closes by it becomes a closed line, its first point not repeated. A joined line stands
/// where the first of its pieces stood, and runs as that one did. Lines that are taken are left
/// without points, and left out. Returns how many were. O(n log n).
std::size_t join_open_lines(std::vector<DrawnLine>& lines);

}  // namespace tetloft::internal::io
