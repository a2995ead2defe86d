// Models whose pictures are known.
#pragma once

#include <array>
#include <cstddef>

#include <tetloft/model.hpp>

namespace tetloft::test {

/// Boxes [0, 2] × [0, 2] × [3 k, 3 k + 3] with k = 0 … slabs − 1, side by side in x by components:
/// six tets around a diagonal each.
inline Model boxes(std::size_t slabs, std::size_t components = 1) {
  Model model;
  model.component_count = components;
  for (std::size_t c = 0; c < components; ++c) {
    const std::size_t first = model.points.size();
    for (std::size_t k = 0; k <= slabs; ++k) {
      for (std::size_t i = 0; i < 4; ++i) {
        model.points.push_back({2.0 * static_cast<double>(i % 2) + 5.0 * static_cast<double>(c),
                                2.0 * static_cast<double>(i / 2), 3.0 * static_cast<double>(k)});
        model.section.push_back(SectionId(k));
        model.contour.push_back(ContourId(0));
        model.origin.push_back(PointOrigin::input);
      }
    }
    for (std::size_t k = 0; k < slabs; ++k) {
      const auto corner = [&](std::size_t i) { return VertexId(first + 4 * k + i); };
      // Ways from corner 0 to corner 7 along x, y, z (1, 2, 4) in each order.
      constexpr std::array<std::array<std::size_t, 2>, 6> kWays{
          {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}}};
      for (const auto& [a, b] : kWays) {
        model.tets.push_back({corner(0), corner(a), corner(b), corner(7)});
        model.component.push_back(ComponentId(c));
        model.slab.push_back(SlabId(k));
        model.kind.push_back(TetKind::cc);
      }
    }
  }
  return model;
}

}  // namespace tetloft::test
