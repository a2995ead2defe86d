// Triangles in space as files of meshes have them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/point.hpp>
#include <tetloft/result.hpp>

namespace tetloft::internal::io {

struct TriangleSoup {
  std::vector<Point3> points;  ///< finite; equal ones may stand twice
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Warning> warnings;
};

}  // namespace tetloft::internal::io
