// The canonical order of points in space, (z, x, y), of many at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay3_detail {

/// The places in `points` in canonical order; of equal points the first comes first.
/// Requires finite points, fewer than 2^32.
[[nodiscard]] std::vector<std::uint32_t> canonical_order(std::span<const Point3> points,
                                                         unsigned threads = 1);

}  // namespace tetloft::internal::delaunay3_detail
