// What the tests of delaunay2 trust: brute force over predicates by definition
// (support/exact), and counting.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay.hpp>

#include "planar_sets.hpp"

namespace tetloft::test {

/// The value of a result; a failure ends the test as an exception.
Triangulation2 triangulate(std::span<const Point2> points);
Conforming2 conform(const Graph& graph, const ConformingOptions& options = {});
ConformingOptions all_gabriel(const Graph& graph);

/// The triangulation in canonical form, by testing every three different points against
/// every other: O(n^4).
std::vector<PlaneTriangleVertices> brute_force_triangles(std::span<const Point2> points);

/// Form, order, adjacency and coverage: triangles counter-clockwise, each starting at its
/// lowest vertex, sorted; neighbours mutual across the same edge; every first of equal
/// points used; hull convex; Euler's formula.
testing::AssertionResult is_canonical(const Triangulation2& t);

enum class Trust { definition, library };
/// No vertex opposite an edge lies in the perturbed circle of its other triangle: by
/// Delaunay's lemma then all circles are empty. `Trust::definition` is slow.
testing::AssertionResult is_locally_delaunay(const Triangulation2& t, Trust predicates);

/// Chains run from end to end of their segments in order, along edges of the triangulation,
/// at most 4 ulps off their segments; `split` and `chains` describe the same.
testing::AssertionResult respects(const Conforming2& c, const Graph& graph);

/// No vertex lies in or on the diametral circle of a chain's edge, but its ends: every
/// vertex against every edge, exactly.
testing::AssertionResult is_gabriel(const Conforming2& c, const Graph& graph);

/// The points that were inserted, sorted.
Points inserted(const Conforming2& c, const Graph& graph);

}  // namespace tetloft::test
