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
/// `n` points in `count` clusters a thousandth wide, nearly Gaussian, in the unit cube.
std::vector<Point3> clusters(std::size_t n, std::size_t count);
/// `n` points on `count` segments of the unit cube, up to rounding.
std::vector<Point3> lines(std::size_t n, std::size_t count);
/// The same on parabolas.
std::vector<Point3> curves(std::size_t n, std::size_t count);
/// `n` points around a segment, a thousandth of its length away, nearly Gaussian.
std::vector<Point3> around_line(std::size_t n);
/// (t, t², t³) at `n` places t in [-1, 1]: each two neighbours along the curve make tets with each
/// other two, so that there are about n² / 2.
std::vector<Point3> moment_curve(std::size_t n);
std::vector<Point2> uniform2(std::size_t n);

/// A tube with wiggles, of about `vertices` vertices, 200 to a section.
SectionStack tube(std::size_t vertices);

/// Outlines of `vertices` vertices each, as of islands: radii by midpoint displacement, so that
/// they wander by thousands of times the distance of neighbouring vertices, and differ between
/// sections.
SectionStack coasts(std::size_t vertices, std::size_t sections);

/// Wiggly circles of about `vertices` vertices in all, each with a hole: one in the lowest
/// third of the sections, two in the next, four in the last.
SectionStack branching(std::size_t vertices, std::size_t sections);

}  // namespace tetloft::bench
