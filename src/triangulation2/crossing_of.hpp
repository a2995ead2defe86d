// Where two segments cross, rounded.
#pragma once

#include <optional>

#include <tetloft/point.hpp>

namespace tetloft::internal::triangulation2 {

/// The point where the segments a b and c d cross, which they do inside of both; the same for any
/// order of ends and segments. In the boxes of both: what is divided there has smaller boxes, so
/// that dividing ends. An end in whose pixel the other segment runs is that point (as of hot
/// pixels: Hobby, "Practical segment intersection with finite precision output", CGTA 13, 1999):
/// else pieces that lie beside each other would cross at one double after the other, all along.
/// Nothing where products leave the range of doubles.
[[nodiscard]] std::optional<Point2> crossing_of(Point2 a, Point2 b, Point2 c, Point2 d);

}  // namespace tetloft::internal::triangulation2
