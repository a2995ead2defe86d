// Oracles and point sets for the tests of delaunay3. Nothing here calls the engine but
// triangulate().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay.hpp>

#include "core/prng.hpp"

namespace tetloft::test {

using namespace internal;

using Points = std::vector<Point3>;

/// delaunay3 of valid points; a failure ends the test as an exception.
Delaunay3 triangulate(std::span<const Point3> points);

/// All tets of the Delaunay triangulation in canonical form, by testing every four points
/// against every other: O(n^5).
std::vector<TetVertices> brute_force_tets(std::span<const Point3> points);

/// The tets of a mesh in its own numbering.
std::vector<TetVertices> tets_of(const TetMesh& mesh);

/// Every tet positive, canonical in form and order.
testing::AssertionResult is_canonical(const Delaunay3& d, std::span<const Point3> points);

/// opposite is an involution that joins equal faces of opposite orientation, and the
/// faces without opposite form a closed surface of Euler characteristic 2 that no point
/// lies beyond.
testing::AssertionResult fills_convex_hull(const Delaunay3& d, std::span<const Point3> points);

/// Across every inner face the far vertex lies outside the perturbed sphere: by
/// Delaunay's lemma then every sphere is empty.
testing::AssertionResult is_locally_delaunay(const Delaunay3& d, std::span<const Point3> points);

/// Every point that is its own representative is in a tet, no other is.
testing::AssertionResult uses_all_points(const Delaunay3& d);

/// All of the above, and the mesh's own validation.
void expect_delaunay(std::span<const Point3> points);
/// The same, and equal to brute force.
void expect_brute_force(std::span<const Point3> points);

/// Six times the sum of the tets' volumes, in plain double arithmetic.
double six_volumes(const Delaunay3& d, std::span<const Point3> points);

/// Integer points of the box [0, nx) × [0, ny) × [0, nz).
Points lattice(int nx, int ny, int nz);
/// Uniform in the unit cube.
Points uniform(std::size_t n, Prng& prng);
/// `n` distinct points of the integer grid [0, side)^3, in random order.
Points grid_subset(std::size_t n, int side, Prng& prng);
/// All integer points of the sphere of that radius around the origin.
Points integer_sphere(int radius);

}  // namespace tetloft::test
