// Oracles of constrained triangulations.
#pragma once

#include <array>
#include <set>

#include "support.hpp"

namespace tetloft::test {

using Edge = std::array<DelaunayVertex, 2>;

/// Do the segments cross inside of both?
[[nodiscard]] bool cross_properly(const Point2& a, const Point2& b, const Point2& c,
                                  const Point2& d);

/// The edges that constraints go over.
[[nodiscard]] std::set<Edge> constrained_edges(const DelaunayTriangulation2& t);

/// All vertices on the constraint's segment, in order, are joined.
[[nodiscard]] testing::AssertionResult covers_its_segment(const DelaunayTriangulation2& t,
                                                          ConstraintId c);

/// The triangles by their vertices, in order.
[[nodiscard]] std::set<std::array<DelaunayVertex, 3>> triangles_by_vertices(
    const DelaunayTriangulation2& t);

/// The same handles, points, constraints, edges and triangles?
[[nodiscard]] testing::AssertionResult are_same_constrained(const DelaunayTriangulation2& a,
                                                            const DelaunayTriangulation2& b);

/// Points and constraints that came, divided each other where they cross, and went.
[[nodiscard]] DelaunayTriangulation2 constrained_at_random(const PlaneSource& source, Prng& prng);

/// Neighbours fit, every constrained edge is there, and across every other one the circles are
/// empty: by Lee and Lin (1986) that is the constrained triangulation. Of points whose coordinates
/// are multiples of three, and few, also: areas add up to the hull's, and no vertex in a triangle's
/// circle is seen from its centre of gravity.
[[nodiscard]] testing::AssertionResult is_constrained_delaunay(const DelaunayTriangulation2& t,
                                                               bool multiples_of_three);

}  // namespace tetloft::test
