// Vertices of triangulations that change, as numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/delaunay_vertex.hpp>

#include "c/call.hpp"

namespace tetloft::internal::c {

using VertexNumber = std::uint64_t;

constexpr VertexNumber vertex_number(DelaunayVertex v) {
  return (VertexNumber{v.generation} << 32) | v.index;
}
constexpr DelaunayVertex vertex_of_number(VertexNumber number) {
  return {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)};
}
static_assert(vertex_number(DelaunayVertex()) == TETLOFT_NO_VERTEX);

/// Vertices, or arrays of them, to an array of their numbers; returns its end.
template <class Vertices>
VertexNumber* put_vertices(const Vertices& vertices, VertexNumber* numbers) {
  return std::transform(vertices.begin(), vertices.end(), numbers, vertex_number);
}

[[nodiscard]] inline std::vector<VertexNumber> vertex_numbers(
    const std::vector<DelaunayVertex>& vertices) {
  std::vector<VertexNumber> numbers(vertices.size());
  put_vertices(vertices, numbers.data());
  return numbers;
}
template <std::size_t n>
[[nodiscard]] std::array<VertexNumber, n> vertex_numbers(
    const std::array<DelaunayVertex, n>& vertices) {
  std::array<VertexNumber, n> numbers{};
  put_vertices(vertices, numbers.data());
  return numbers;
}

/// Ends a body with TETLOFT_INVALID_INPUT where there is no such vertex.
template <class Triangulation>
[[nodiscard]] DelaunayVertex live_vertex(const Triangulation& triangulation, VertexNumber number) {
  const DelaunayVertex v = vertex_of_number(number);
  if (!triangulation.is_live(v)) {
    throw Failed(Error{ErrorCode::invalid_input,
                       "there is no vertex " + std::to_string(v.index) + " of generation " +
                           std::to_string(v.generation),
                       {}});
  }
  return v;
}

}  // namespace tetloft::internal::c
