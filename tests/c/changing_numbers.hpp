// Vertices of Delaunay triangulations that change as numbers of C, and arrays of the caller's.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>

#include "c/owned.hpp"

namespace tetloft::c_test {

using Number = std::uint64_t;

inline Number number(DelaunayVertex v) { return (Number{v.generation} << 32) + v.index; }

inline std::vector<Number> numbers(const std::vector<DelaunayVertex>& vertices) {
  std::vector<Number> result;
  for (const DelaunayVertex v : vertices) result.push_back(number(v));
  return result;
}
template <std::size_t n>
std::array<Number, n> numbers(const std::array<DelaunayVertex, n>& vertices) {
  std::array<Number, n> result{};
  for (std::size_t i = 0; i < n; ++i) result[i] = number(vertices[i]);
  return result;
}

/// The vertices of each of the simplices.
template <std::size_t n, class Triangulation, class Simplices>
std::vector<std::array<Number, n>> corners(const Triangulation& t, const Simplices& simplices) {
  std::vector<std::array<Number, n>> result;
  for (const auto simplex : simplices) result.push_back(numbers(t.vertices(simplex)));
  return result;
}

template <class Point>
const double* coordinates(const std::vector<Point>& points) {
  return reinterpret_cast<const double*>(points.data());
}

/// What a call with an array of the caller's gives: asked for the number first, then with an
/// element too few.
template <class T, class Element>
void expect_found(const std::function<tetloft_status(Element*, std::size_t, std::size_t*)>& query,
                  const std::vector<T>& expected) {
  std::size_t count = 12345;
  ASSERT_OK(query(nullptr, 0, &count));
  ASSERT_EQ(count, expected.size());
  std::vector<T> found(count);
  auto* const array = reinterpret_cast<Element*>(found.data());
  if (count > 0) {
    EXPECT_EQ(query(array, count - 1, &count), TETLOFT_TOO_SMALL);
    EXPECT_EQ(count, expected.size());
    EXPECT_EQ(found, std::vector<T>(count)) << "nothing is written";
  }
  ASSERT_OK(query(array, count, &count));
  EXPECT_EQ(found, expected);
}

}  // namespace tetloft::c_test
