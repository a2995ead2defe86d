// Point and segment sets for the tests of delaunay2.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/delaunay.hpp>

#include "core/prng.hpp"

namespace tetloft::test {

using namespace internal;

using Points = std::vector<Point2>;

/// Points and segments between them.
struct Graph {
  Points points;
  std::vector<Segment> segments;
};

/// (0, 0) … (nx − 1, ny − 1).
Points lattice(int nx, int ny);
/// Uniform in the unit square.
Points uniform(std::size_t n, Prng& prng);
/// `n` different points of the grid [0, side)², in random order.
Points grid_subset(std::size_t n, int side, Prng& prng);
/// All integer points on the circle of that squared radius around the origin.
Points integer_circle(int squared_radius);
/// Random signs, and exponents between the two, of base 2.
Points scattered_exponents(std::size_t n, int low, int high, Prng& prng);
Points times(Points points, double factor);

/// The closed polygon through all points in order.
Graph polygon(Points points);
/// Star-shaped around the origin, with radii from `low` to 1.
Graph star_polygon(std::size_t n, double low, Prng& prng);
/// The region under an integer graph over 0 … n: a lattice polygon with acute corners.
Graph skyline(int n, int height, Prng& prng);
/// Segments from (0, 0) at `n` angles from 0 to `sector`, of random lengths up to 1.
Graph fan(std::size_t n, double sector, Prng& prng);
/// Both graphs, which must not meet.
Graph operator+(Graph a, const Graph& b);

/// The same graph with points and segments in random order and segments in random
/// directions. renamed[v], if asked for, is the new index of point v.
Graph shuffled(const Graph& graph, Prng& prng, std::vector<std::size_t>* renamed = nullptr);

/// Sorted by coordinates.
Points sorted(Points points);

}  // namespace tetloft::test
