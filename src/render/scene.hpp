// What a still picture shows: triangles and lines, cut and moved apart.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <tetloft/render.hpp>

#include "render/subject.hpp"

namespace tetloft::internal::render {

struct SceneTriangle {
  std::array<Point3, 3> corner;  ///< counter-clockwise from outside
  std::array<Point3, 3> normal;
  Rgb colour;
  std::uint8_t outline = 0;  ///< bit i: corners i and i + 1 are joined by an edge of a tet
};

struct Scene {
  std::vector<SceneTriangle> triangles;
  std::vector<std::array<Point3, 2>> lines;
  double line_gap = 0;  ///< mean height between lines
  int exponent = 0;     ///< as Subject::exponent
};

/// `toward`: the direction in which the eye stands. Errors as subject_of().
[[nodiscard]] Result<Scene> scene_of(const Model& model, const SectionStack* contours,
                                     const Point3& toward, const RenderOptions& options);

}  // namespace tetloft::internal::render
