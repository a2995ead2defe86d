// Oracles for triangulations that change: the batch, and all points against all.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <tetloft/delaunay_triangulation2.hpp>

#include "core/prng.hpp"

namespace tetloft::test {

using internal::Prng;

/// A source of points, many of them degenerate or repeated.
struct PlaneSource {
  std::string name;
  std::function<Point2(Prng&)> draw;
};
[[nodiscard]] std::vector<PlaneSource> plane_sources();

/// The live vertices by index.
[[nodiscard]] std::vector<DelaunayVertex> live_vertices(const DelaunayTriangulation2& t);

/// Triangles and neighbours are those of delaunay2() of the live points, edges of a row those of
/// its order; counts, stars, hull and dimension fit.
[[nodiscard]] testing::AssertionResult equals_batch(const DelaunayTriangulation2& t);

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
