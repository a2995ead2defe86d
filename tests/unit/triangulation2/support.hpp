// Oracles for triangulations that change: the batch, and all points against all.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay_triangulation2.hpp>

#include "support/changing_triangulations.hpp"

namespace tetloft::test {

/// In the plane.
using PlaneSource = SourceOf<Point2>;
[[nodiscard]] std::vector<PlaneSource> plane_sources();

/// Triangles and neighbours are those of delaunay2() of the live points, edges of a row those of
/// its order; counts, stars, hull and dimension fit.
[[nodiscard]] testing::AssertionResult equals_batch(const DelaunayTriangulation2& t);

}  // namespace tetloft::test
