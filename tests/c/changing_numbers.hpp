// Vertices of Delaunay triangulations that change as numbers of C, and arrays of the caller's.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
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

template <std::size_t n>
std::vector<std::array<Number, n>> numbers(
    const std::vector<std::array<DelaunayVertex, n>>& simplices) {
  std::vector<std::array<Number, n>> result;
  for (const auto& vertices : simplices) result.push_back(numbers(vertices));
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
  if (count > 0) {
    EXPECT_TRUE(same_array(found.data(), count, expected)) << "bit for bit";
  }
}

/// The three arrays of a conflict zone: `query(cells, capacity, count, horizon, …)` of a capacity
/// and a count each; asked for the numbers first, then with one element too few in each of them.
template <std::size_t corners, class Query>
void expect_zone(const Query& query, const std::vector<std::array<Number, corners>>& cells,
                 const std::vector<std::array<Number, corners - 1>>& horizon,
                 const std::vector<Number>& neighbours) {
  std::array<std::size_t, 3> counts{7, 7, 7};
  std::vector<std::array<Number, corners>> found_cells;
  std::vector<std::array<Number, corners - 1>> found_horizon;
  std::vector<Number> found_neighbours;
  const auto ask = [&](const std::array<std::size_t, 3>& capacities) {
    return query(reinterpret_cast<Number*>(found_cells.data()), capacities[0], &counts[0],
                 reinterpret_cast<Number*>(found_horizon.data()), capacities[1], &counts[1],
                 found_neighbours.data(), capacities[2], &counts[2]);
  };
  ASSERT_OK(ask({}));
  const std::array expected{cells.size(), horizon.size(), neighbours.size()};
  ASSERT_EQ(counts, expected);
  found_cells.resize(counts[0]);
  found_horizon.resize(counts[1]);
  found_neighbours.resize(counts[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (expected[k] == 0) continue;
    auto capacities = expected;
    --capacities[k];
    counts = {};
    EXPECT_EQ(ask(capacities), TETLOFT_TOO_SMALL);
    EXPECT_EQ(counts, expected);
    EXPECT_EQ(found_cells, decltype(found_cells)(cells.size())) << "nothing is written";
    EXPECT_EQ(found_horizon, decltype(found_horizon)(horizon.size()));
    EXPECT_EQ(found_neighbours, decltype(found_neighbours)(neighbours.size()));
  }
  ASSERT_OK(ask(expected));
  EXPECT_EQ(found_cells, cells);
  EXPECT_EQ(found_horizon, horizon);
  EXPECT_EQ(found_neighbours, neighbours);
}

/// Calls `change(i)` a hundred times while three threads go on calling `ask()`.
template <class Ask, class Change>
void change_while_others_ask(const Ask& ask, const Change& change) {
  std::atomic<bool> done{false};
  std::vector<std::thread> threads;
  for (int k = 0; k < 3; ++k) {
    threads.emplace_back([&] {
      do {
        ask();
      } while (!done);
    });
  }
  for (int i = 0; i < 100; ++i) change(i);
  done = true;
  for (std::thread& thread : threads) thread.join();
}

}  // namespace tetloft::c_test
