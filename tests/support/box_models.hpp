// Models whose every figure is known: boxes, each of six tets.
#pragma once

#include <algorithm>
#include <array>
#include <string>

#include <tetloft/model.hpp>

namespace tetloft::testing {

/// The box between two corners, of a component. Its tets go from the lower corner to the upper one
/// along the three axes, in each order of these.
inline void add_box(Model& model, int component, const Point3& low, const Point3& high) {
  const std::size_t first = model.points.size();
  for (unsigned k = 0; k < 8; ++k) {
    model.points.push_back({(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y,
                            (k & 4U) != 0 ? high.z : low.z});
  }
  std::array<unsigned, 3> axes{0, 1, 2};
  do {
    const unsigned second = 1U << axes[0];
    const unsigned third = second | 1U << axes[1];
    TetVertices tet{VertexId(first), VertexId(first + second), VertexId(first + third),
                    VertexId(first + 7)};
    const bool odd = (axes[0] > axes[1]) != ((axes[1] > axes[2]) != (axes[0] > axes[2]));
    if (odd) std::swap(tet[2], tet[3]);
    model.tets.push_back(tet);
    model.component.push_back(ComponentId(component));
  } while (std::next_permutation(axes.begin(), axes.end()));
  model.component_count = std::max(model.component_count, static_cast<std::size_t>(component) + 1);
}

/// Names that careless writers break.
inline const std::array<std::string, 3> kHardNames{
    "left \"lung\" & <b>'x'</b> \\", "L\xC3\xA4sion \xE8\x82\x9D", "two\nlines\t\x01 #1, 100%"};

/// A patient's boxes of volumes 24, 6 and 0.125, of the components 1, 0 and 3, tets of which take
/// turns; component 2 has none. They lie across all axes of the file's space.
inline Model boxes_in_a_patient() {
  Model ordered;
  add_box(ordered, 1, {-2, 0, 0}, {0, 3, 4});
  add_box(ordered, 0, {1, 1, 0.1}, {2, 3, 3.1});
  add_box(ordered, 3, {-1, -3, -1}, {-0.5, -2.5, -0.5});
  Model model = ordered;
  for (std::size_t k = 0; k < ordered.tets.size(); ++k) {
    const TetId from(k % 3 * 6 + k / 3);
    model.tets[TetId(k)] = ordered.tets[from];
    model.component[TetId(k)] = ordered.component[from];
  }
  model.about = {kHardNames[0], "mm", "LPS"};
  model.component_names.assign(4, "");
  model.component_names[ComponentId(0)] = kHardNames[1];
  model.component_names[ComponentId(1)] = kHardNames[2];
  model.frame = {{{{0.6, 0.8, 0}, {-0.48, 0.36, 0.8}, {0.64, -0.48, 0.6}}}, {-100.3, 20.7, 1000.1}};
  return model;
}

}  // namespace tetloft::testing
