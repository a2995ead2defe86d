// What is asked of Delaunay triangulations that change, in space and in the plane.
#pragma once

#include <cstdint>
#include <vector>

#include "c/calls/calls.hpp"

namespace tetloft::c_test {

/// Arrays for as many points as there are at most: 40 coordinates.
inline constexpr std::size_t kMostPoints = 40;

[[nodiscard]] inline std::uint64_t vertex(Arguments& a, std::int64_t usual) {
  return static_cast<std::uint64_t>(a.integer(usual));
}

/// Of all of it.
template <class Handle, class Number, class Query>
tetloft_status of_all(Arguments& a, Query query, std::size_t tuple) {
  auto* const delaunay = a.handle<Handle>();
  const auto array = a.output_array<Number>(tuple);
  return query(delaunay, array.data, array.size, a.output<std::size_t>());
}

/// Of one of its vertices.
template <class Handle, class Query>
tetloft_status around_vertex(Arguments& a, Query query, std::size_t tuple) {
  auto* const delaunay = a.handle<Handle>();
  const std::uint64_t of = vertex(a, 1);
  const auto array = a.output_array<std::uint64_t>(tuple);
  return query(delaunay, of, array.data, array.size, a.output<std::size_t>());
}

/// A vertex for each of some points.
template <class Handle, class Query>
tetloft_status for_points(Arguments& a, Handle* delaunay, Query query,
                          const std::vector<double>& usual, std::size_t coordinates) {
  const auto points = a.array(a.reals(usual), coordinates);
  const auto* const how = execution(a);
  std::vector<std::uint64_t> vertices(kMostPoints);
  return query(delaunay, points.data, points.size, how, vertices.data());
}

}  // namespace tetloft::c_test
