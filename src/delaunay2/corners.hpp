// Which ends of which segments form acute corners.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay2_detail {

/// By segment and end: does another segment that shares this end form an angle below 90°
/// with it? Exact. Above 90°, and at right angles, segments cannot encroach upon each other
/// from their common end, and from 60° on midpoints would do; but 90° is a question a
/// predicate answers, and shells (shells.hpp) do no harm up to there.
/// Requires distinct points and segments that meet at their ends only.
[[nodiscard]] std::vector<std::array<bool, 2>> acute_ends(std::span<const Point2> points,
                                                          std::span<const Segment> segments);

}  // namespace tetloft::internal::delaunay2_detail
