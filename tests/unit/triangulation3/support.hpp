// Oracles for triangulations that change: the batch, and all points against all.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay_triangulation3.hpp>

#include "core/prng.hpp"

namespace tetloft::test {

using internal::Prng;

/// A source of points, many of them degenerate or repeated.
struct PointSource {
  std::string name;
  std::function<Point3(Prng&)> draw;
};
[[nodiscard]] std::vector<PointSource> point_sources();

/// The live vertices by index.
[[nodiscard]] std::vector<DelaunayVertex> live_vertices(const DelaunayTriangulation3& t);

/// Tets, facets of the hull and neighbours across faces are those of delaunay3() of the live
/// points; counts, handles and stars fit.
[[nodiscard]] testing::AssertionResult equals_batch(const DelaunayTriangulation3& t);

/// Edges and facets of points that span no space: every empty circle, or every two neighbours in a
/// row, found by testing all points.
[[nodiscard]] testing::AssertionResult equals_flat_oracle(const DelaunayTriangulation3& t);

/// A value that is there, or a failed test that ends.
template <class T>
T value_of(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return *std::move(result);
}
inline void succeed(const Result<void>& result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
}

}  // namespace tetloft::test
