// Tetrahedral meshes as VTK XML unstructured grids (.vtu).
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/arguments.hpp"
#include "io/stage.hpp"
#include "io/vtk_write.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

namespace {

using io::vtk_array;
using io::VtkArray;
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

// An invalid id is written as −1.
template <class Ids>
VtkArray id_array(const char* name, const Ids& ids) {
  return vtk_array<std::int32_t>(name, 1, ids.size(), [&ids](std::size_t i) {
    return static_cast<std::int32_t>(ids.raw()[i].value());
  });
}

template <class Enums>
VtkArray enum_array(const char* name, const Enums& values) {
  return vtk_array<std::uint8_t>(name, 1, values.size(), [&values](std::size_t i) {
    return static_cast<std::uint8_t>(values.raw()[i]);
  });
}

// Arrays without values are left out: a model need not have provenance.
void add_unless_empty(VtkGroup& group, VtkArray array) {
  if (array.bytes != 0) group.arrays.push_back(std::move(array));
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
    VtkGroup point_data{"PointData", {}};
    add_unless_empty(point_data, id_array("section", model.section));
    add_unless_empty(point_data, id_array("contour", model.contour));
    add_unless_empty(point_data, enum_array("origin", model.origin));
    VtkGroup cell_data{"CellData", {}};
    add_unless_empty(cell_data, id_array("component", model.component));
    add_unless_empty(cell_data, id_array("slab", model.slab));
    add_unless_empty(cell_data, enum_array("kind", model.kind));
    return stage(
        path,
        {point_data, cell_data, point_group(model.points.raw()), cell_group(model.tets.raw())},
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
