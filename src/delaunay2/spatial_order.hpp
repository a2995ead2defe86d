// The order of insertion: biased randomised rounds, each along a Hilbert curve.
//
// Every point draws its round; the last holds about three quarters of them, the one before
// three quarters of the rest, and so on. The randomness bounds the expected number of
// triangles ever made for any input, also for points in order along a smooth curve, where
// a plain spatial order can be quadratic; the curve keeps each walk short and its memory
// warm (Amenta, Choi and Rote, "Incremental constructions con BRIO", SoCG 2003).
//
// Round and place are functions of the coordinates alone, so equal points are neighbours
// in the order, and the order of the input matters only among points of one grid cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tetloft/point.hpp>

namespace tetloft::internal::delaunay2_detail {

/// The indices of `points` in the order in which to insert them.
/// Requires finite points, fewer than 2^32.
/// (1) A permutation of 0 … n − 1. (2) Of equal points the one with the lowest index comes
/// first.
[[nodiscard]] std::vector<std::uint32_t> insertion_order(std::span<const Point2> points);

}  // namespace tetloft::internal::delaunay2_detail
