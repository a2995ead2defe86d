// Conforming triangulation: rounds of splits until every segment is a chain of edges.
//
// A round looks at all subsegments that may have changed, splits those that are missing (or
// not Gabriel, where asked for), each at the point that its own ends and corner determine
// (shells.hpp), and inserts the new points together. Which points a round inserts depends on
// the set of points and of segments only, since the triangulation is unique: so does the
// result, whatever the order of points, segments, or ends in the input.
//
// It ends: a missing subsegment has a vertex in or on its diametral circle, and splitting
// encroached subsegments at midpoints, and on shells at acute corners, stops at the scale of
// the features (Ruppert 1995, Shewchuk 2002). Where that scale is below what doubles resolve,
// a subsegment runs out of room, which is an Error; so does the bound on inserted points
// catch requests that end, but later than anyone would wait.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <tetloft/delaunay2.hpp>
#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

#include "core/watched_work.hpp"
#include "delaunay2/start.hpp"

namespace tetloft::internal::delaunay2_detail {

/// conforming_delaunay2() for arguments that have been checked: `start` has a plane, points
/// are finite and distinct, segments distinct, with valid and different ends, flags none or
/// one for each. `most_inserted` bounds the number of inserted points. Tells no
/// step.
[[nodiscard]] Result<Conforming2> conform(Start start, std::span<const Point2> points,
                                          std::span<const Segment> segments,
                                          const std::vector<bool>& gabriel,
                                          std::size_t most_inserted, WatchedWork& work);

}  // namespace tetloft::internal::delaunay2_detail
