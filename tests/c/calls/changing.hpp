// What is asked of Delaunay triangulations that change, in space and in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
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

/// The three arrays of a conflict zone, of tets or triangles of so many `corners`.
template <class Query>
tetloft_status zone(Arguments& a, std::size_t corners, Query query) {
  const auto cells = a.output_array<std::uint64_t>(corners);
  auto* const cell_count = a.output<std::size_t>();
  const auto horizon = a.output_array<std::uint64_t>(corners - 1);
  auto* const horizon_count = a.output<std::size_t>();
  const auto neighbours = a.output_array<std::uint64_t>();
  return query(cells.data, cells.size, cell_count, horizon.data, horizon.size, horizon_count,
               neighbours.data, neighbours.size, a.output<std::size_t>());
}

/// The bytes of a new one.
template <class Handle>
std::vector<char> serialised(tetloft_status (*serialise)(const Handle*, tetloft_bytes**)) {
  constexpr Kind kind = KindOf<Handle>::value;
  auto* const delaunay = static_cast<Handle*>(new_handle(kind));
  tetloft_bytes* bytes = nullptr;
  const tetloft_status status = serialise(delaunay, &bytes);
  free_handle(kind, delaunay);
  if (status != TETLOFT_OK) throw std::bad_alloc();
  const void* data = nullptr;
  std::size_t size = 0;
  tetloft_bytes_data(bytes, &data, &size);
  std::array<char, 1024> copy{};
  size = std::min(size, copy.size());
  std::copy_n(static_cast<const char*>(data), size, copy.begin());
  free_handle(Kind::bytes, bytes);
  return {copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(size)};
}

}  // namespace tetloft::c_test
