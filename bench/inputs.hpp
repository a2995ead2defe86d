// Point sets and stacks of the benchmark, from the project's own generator: the same bytes
// on every machine.
#pragma once

#include <cstddef>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/sections.hpp>

namespace tetloft::bench {

std::vector<Point3> uniform3(std::size_t n);
/// The integer points of [0, side)³, shuffled.
std::vector<Point3> grid3(std::size_t side);
/// On the unit sphere up to rounding.
std::vector<Point3> sphere(std::size_t n);
/// On a sphere with bumps.
std::vector<Point3> bumpy_sphere(std::size_t n);
/// `n` vertices of wiggly circles in each of the planes z = 0 and z = 1.
std::vector<Point3> two_planes(std::size_t n);
/// The same on a half-integer pixel lattice.
std::vector<Point3> two_pixel_planes(std::size_t n);
/// Slab `k` of a stack of wiggly circles, n vertices in each plane.
std::vector<Point3> thin_slab(std::size_t n, std::size_t k);
std::vector<Point2> uniform2(std::size_t n);

/// A tube with wiggles, of about `vertices` vertices, 200 to a section.
SectionStack tube(std::size_t vertices);

}  // namespace tetloft::bench
