// The order of insertion: a biased randomised insertion order (Amenta, Choi and Rote,
// "Incremental constructions con BRIO", SoCG 2003).
//
// Every point draws its round; each round holds about kRoundRatio times the points of all
// earlier ones, which keeps the expected cost of the randomised incremental construction.
// Within a round the points follow a Hilbert curve, so that the next point is near the
// last one: the walk is short and the memory it touches is hot. Points the grid of the
// curve cannot tell apart are ordered along finer ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay3_detail {

/// A point leaves the last round for the one before with probability 1 / kRoundRatio, and so on.
inline constexpr std::size_t kRoundRatio = 8;

/// The places in `points` in the order they should be inserted.
/// Requires: finite points in canonical order.
/// (1) A permutation of 0 … n−1. (2) Depends on the points only.
[[nodiscard]] std::vector<std::uint32_t> insertion_order(std::span<const Point3> points,
                                                         unsigned threads = 1);

}  // namespace tetloft::internal::delaunay3_detail
