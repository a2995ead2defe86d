// The parts of a .vtu, wherever their values are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>
#include <tetloft/model.hpp>

#include "io/vtk_write.hpp"
#include "io/vtu_read.hpp"

namespace tetloft::internal::io {

struct VtuGrid {
  VtkGroup tables;               ///< the data of the whole
  std::vector<VtkGroup> fields;  ///< of points, of tets
  VtkGroup points;
  VtkGroup cells;  ///< vtu_cells()
};

[[nodiscard]] std::vector<Warning> append_vtu(Sink& sink, VtuGrid grid, Encoding encoding);

/// The tables of a model, each left out where it is empty.
[[nodiscard]] VtkGroup vtu_tables(const Model& model);

/// The element Cells, of tets; corner(i) is vertex i % 4 of tet i / 4.
template <class Corner>
VtkGroup vtu_cells(std::size_t tets, Corner corner) {
  VtkGroup group{"Cells", {}};
  group.arrays.push_back(vtk_array<std::int64_t>("connectivity", 1, 4 * tets, std::move(corner)));
  group.arrays.push_back(vtk_array<std::int64_t>(
      "offsets", 1, tets, [](std::size_t i) { return static_cast<std::int64_t>(4 * (i + 1)); }));
  group.arrays.push_back(
      vtk_array<std::uint8_t>("types", 1, tets, [](std::size_t) { return kVtkTetra; }));
  return group;
}

}  // namespace tetloft::internal::io
