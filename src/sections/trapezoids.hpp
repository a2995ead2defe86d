// A region as signed trapezoids: one below each of its edges that is not vertical.
//
// The indicator of a region is the sum over its edges of side · [below the edge]: side is
// +1 where the region lies below the edge and −1 where it lies above. Sums over the edges
// do not depend on the level that the trapezoids reach down to, as the sides of the edges
// over any x add up to zero. Areas and overlaps (overlap.cpp) follow without any topology.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <tetloft/overlap.hpp>

#include "arithmetic/big_integer.hpp"
#include "arithmetic/interval.hpp"
#include "spatial/box_tree.hpp"

namespace tetloft::internal::sections {

/// The edge from left to right, left.x < right.x.
struct Trapezoid {
  Point2 left, right;
  int side = 0;
};

struct Trapezoids {
  std::vector<Trapezoid> edges;
  Box2 box;  ///< of all edges, vertical ones included
};

/// The trapezoids of a closed polygon; those of the reversed one with the sides negated.
[[nodiscard]] Trapezoids trapezoids_of(const Contour& contour);
/// The trapezoids of a region: outer contour and holes in whichever direction.
[[nodiscard]] Trapezoids trapezoids_of(const RegionOutline& region);

/// The power of two that scales the largest coordinate of `box` into [1/2, 1), or as near
/// to it as scales go.
[[nodiscard]] int scale_of(const Box2& box);
/// Multiplies by 2^scale. False, and the edges unusable, if that is not exact.
[[nodiscard]] bool rescale(std::vector<Trapezoid>& edges, int scale);

/// Twice the signed area. Requires coordinates below 1 in magnitude.
[[nodiscard]] Interval twice_area(const std::vector<Trapezoid>& edges);

/// The largest power of two (its exponent) that divides all coordinates.
[[nodiscard]] int lattice_exponent(const std::vector<Trapezoid>& edges);

/// A trapezoid in integers: units of a lattice, from an origin.
template <class Int>
struct IntegerTrapezoid {
  Int x0, y0, x1, y1;
  int side;
};

/// Coordinates relative to `origin` in units of 2^unit; exact.
template <class Int>
[[nodiscard]] std::vector<IntegerTrapezoid<Int>> in_units(const std::vector<Trapezoid>& edges,
                                                          const Point2& origin, int unit);

/// Twice the signed area in square units.
[[nodiscard]] BigInteger twice_area(const std::vector<IntegerTrapezoid<BigInteger>>& edges);
[[nodiscard]] BigInteger twice_area(const std::vector<IntegerTrapezoid<Int128>>& edges);

}  // namespace tetloft::internal::sections
