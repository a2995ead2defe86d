// Oracles for triangulations that change: the batch, and all points against all.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay_triangulation3.hpp>

#include "support/changing_triangulations.hpp"

namespace tetloft::test {

/// In space.
using PointSource = SourceOf<Point3>;
[[nodiscard]] std::vector<PointSource> point_sources();

/// Tets, facets of the hull and neighbours across faces are those of delaunay3() of the live
/// points; counts, handles and stars fit.
[[nodiscard]] testing::AssertionResult equals_batch(const DelaunayTriangulation3& t);

/// Edges and facets of points that span no space: every empty circle, or every two neighbours in a
/// row, found by testing all points.
[[nodiscard]] testing::AssertionResult equals_flat_oracle(const DelaunayTriangulation3& t);

}  // namespace tetloft::test
