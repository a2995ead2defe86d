// Tetrahedral meshes as VTK XML unstructured grids (.vtu).
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/arguments.hpp"
#include "io/stage.hpp"
#include "io/vtk_write.hpp"
#include "model/fields.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

namespace {

using io::vtk_array;
using io::VtkGroup;

constexpr std::uint8_t kVtkTetra = 10;

double coordinate(const Point3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

VtkGroup point_group(const std::vector<Point3>& points) {
  VtkGroup group{"Points", {}};
  group.arrays.push_back(
      vtk_array<double>("Points", 3, 3 * points.size(),
                        [&points](std::size_t i) { return coordinate(points[i / 3], i % 3); }));
  return group;
}

VtkGroup cell_group(const std::vector<TetVertices>& tets) {
  VtkGroup group{"Cells", {}};
  group.arrays.push_back(vtk_array<std::int64_t>(
      "connectivity", 1, 4 * tets.size(),
      [&tets](std::size_t i) { return static_cast<std::int64_t>(tets[i / 4][i % 4].value()); }));
  group.arrays.push_back(vtk_array<std::int64_t>("offsets", 1, tets.size(), [](std::size_t i) {
    return static_cast<std::int64_t>(4 * (i + 1));
  }));
  group.arrays.push_back(
      vtk_array<std::uint8_t>("types", 1, tets.size(), [](std::size_t) { return kVtkTetra; }));
  return group;
}

// The fields of points or of tets; without values they are left out: a model need not have
// provenance.
VtkGroup field_group(const char* element, const Model& model, bool of_points) {
  VtkGroup group{element, {}};
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    const auto& values = (model.*field.values).raw();
    if (Field::kOfPoints != of_points || values.empty()) return;
    group.arrays.push_back(vtk_array<typename Field::Stored::Type>(
        std::string(field.name), 1, values.size(),
        [&values](std::size_t i) { return Field::Stored::store(values[i]); }));
  });
  return group;
}

Result<io::PendingFile> stage(const std::string& path, const std::vector<VtkGroup>& groups,
                              std::size_t points, std::size_t tets, Encoding encoding,
                              io::TemporaryWatcher* watcher) {
  io::PendingFile file(path, watcher);
  io::append_vtk_file(file, "UnstructuredGrid",
                      "NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" +
                          std::to_string(tets) + '"',
                      groups, encoding);
  return finished(std::move(file));
}

}  // namespace

Result<io::PendingFile> io::stage_vtu(const std::string& path, const Model& model,
                                      Encoding encoding, TemporaryWatcher* watcher) {
  return guard_internal([&]() -> Result<PendingFile> {
    if (Result<void> known = check_encoding(encoding); !known) return known.error();
    if (Result<void> formed = check_well_formed(model); !formed) return at_file(path, formed);
    return stage(path,
                 {field_group("PointData", model, true), field_group("CellData", model, false),
                  point_group(model.points.raw()), cell_group(model.tets.raw())},
                 model.points.size(), model.tets.size(), encoding, watcher);
  });
}

Result<io::PendingFile> io::stage_vtu(const std::string& path, const std::vector<Point3>& points,
                                      const std::vector<TetVertices>& tets, Encoding encoding,
                                      TemporaryWatcher* watcher) {
  return guard_internal([&]() -> Result<PendingFile> {
    if (Result<void> known = check_encoding(encoding); !known) return known.error();
    if (Result<void> formed = check_tets(points.size(), tets); !formed) {
      return at_file(path, formed);
    }
    return stage(path, {point_group(points), cell_group(tets)}, points.size(), tets.size(),
                 encoding, watcher);
  });
}

Result<void> write_vtu(const std::string& path, const Model& model, Encoding encoding) {
  return io::committed(io::stage_vtu(path, model, encoding));
}

Result<void> write_vtu(const std::string& path, const std::vector<Point3>& points,
                       const std::vector<TetVertices>& tets, Encoding encoding) {
  return io::committed(io::stage_vtu(path, points, tets, encoding));
}

}  // namespace tetloft
