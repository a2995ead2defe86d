// A triangle mesh of which every edge has an even number of triangles, paired.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <tetloft/frame.hpp>
#include <tetloft/result.hpp>
#include <tetloft/slice.hpp>

namespace tetloft::internal::sections {

/// Half-edge 3t + k runs from corner k of triangle t to the next one.
struct ClosedMesh {
  std::vector<Point3> points;  ///< distinct, in canonical order; −0 is 0
  /// Three different corners; the lowest first, in order. So the numbering of the file does not
  /// matter.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// By half-edge the other one of its pair, at the same edge of another triangle.
  std::vector<std::uint32_t> mate;
  std::vector<Warning> warnings;  ///< of triangles left out

  [[nodiscard]] std::uint32_t from(std::uint32_t half_edge) const {
    return triangles[half_edge / 3][half_edge % 3];
  }
  [[nodiscard]] std::uint32_t to(std::uint32_t half_edge) const {
    return triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
  }
};

/// What slice.hpp says of meshes, points and triangles being valid. Error invalid_input naming an
/// edge by its ends where the mesh is not closed. What is told has its place by `frame`.
[[nodiscard]] Result<ClosedMesh> close_mesh(std::vector<Point3> points,
                                            std::vector<std::array<std::uint32_t, 3>> triangles,
                                            const Frame& frame);

}  // namespace tetloft::internal::sections
