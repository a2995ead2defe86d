// Tetrahedral meshes as VTK XML unstructured grids (.vtu).
#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/guard.hpp"
#include "core/text.hpp"
#include "io/arguments.hpp"
#include "io/format.hpp"
#include "io/stage.hpp"
#include "io/vtk_data.hpp"
#include "io/vtk_text.hpp"
#include "io/vtk_write.hpp"
#include "io/vtu_frame.hpp"
#include "io/vtu_grid.hpp"
#include "io/vtu_piece.hpp"
#include "io/vtu_read.hpp"
#include "model/fields.hpp"
#include "model/tables.hpp"
#include "model/well_formed.hpp"

namespace tetloft::internal::io {

namespace {

// The fields of points or of tets; without values they are left out: a model need not have
// provenance. Pieces have them always: those of a solid have the same arrays, also where one is
// empty.
VtkGroup field_group(const char* element, const Model& model, bool of_points, bool of_piece) {
  VtkGroup group{element, {}};
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    const auto& values = (model.*field.values).raw();
    const bool is_there = !values.empty() || (of_piece && Field::due(model) == 0);
    if (Field::kOfPoints != of_points || !is_there) return;
    group.arrays.push_back(vtk_array<typename Field::Stored::Type>(
        std::string(field.name), 1, values.size(),
        [&values](std::size_t i) { return Field::Stored::store(values[i]); }));
  });
  return group;
}

VtkArray frame_array(const Frame& frame) {
  return vtk_array<double>(std::string(kFrameArray), kFrameNumbers, kFrameNumbers,
                           [numbers = numbers_of(frame)](std::size_t i) { return numbers[i]; });
}

VtkArray piece_array(std::string_view bytes) {
  return vtk_array<std::uint8_t>(std::string(kPieceArray), 1, bytes.size(), [bytes](std::size_t i) {
    return static_cast<std::uint8_t>(bytes[i]);
  });
}

VtkArray stack_point_array(const IdVector<VertexId, Point3>& points) {
  return vtk_array<double>(std::string(kStackPointArray), 3, 3 * points.size(),
                           [&points](std::size_t i) {
                             const Point3& p = points[VertexId(i / 3)];
                             return i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
                           });
}

// `fields`: of points, of tets.
std::vector<Warning> append_mesh(Sink& sink, VtkGroup tables, std::vector<VtkGroup> fields,
                                 const std::vector<Point3>& points,
                                 const std::vector<TetVertices>& tets, Encoding encoding) {
  return append_vtu(
      sink,
      {std::move(tables), std::move(fields),
       vtk_points(points.size(), [&points](std::size_t i) -> const Point3& { return points[i]; }),
       vtu_cells(tets.size(),
                 [&tets](std::size_t i) {
                   return static_cast<std::int64_t>(tets[i / 4][i % 4].value());
                 })},
      encoding);
}

Written write_grid(Sink& sink, const Model& model, const Target& target) {
  const bool of_piece = !target.piece.empty();
  std::vector<VtkGroup> fields{field_group("PointData", model, true, of_piece),
                               field_group("CellData", model, false, of_piece)};
  VtkGroup tables = vtu_tables(model);
  if (target.stack_points != nullptr) {
    tables.arrays.push_back(frame_array(model.frame));
    if (!is_exact(model.frame)) fields[0].arrays.push_back(stack_point_array(*target.stack_points));
  }
  add_texts(model, tables);
  if (of_piece) tables.arrays.push_back(piece_array(target.piece));
  return append_mesh(sink, std::move(tables), std::move(fields), model.points.raw(),
                     model.tets.raw(), target.options.encoding);
}

// A mesh that is no model: checked as models are.
Written write_mesh(Sink& sink, const std::vector<Point3>& points,
                   const std::vector<TetVertices>& tets, Encoding encoding) {
  if (Result<void> known = check_encoding(encoding); !known) return known.error();
  if (Result<void> formed = check_tets(points.size(), tets); !formed) return formed.error();
  return append_mesh(sink, {}, {}, points, tets, encoding);
}

bool is_grid(std::string_view bytes) { return is_vtk_file(bytes, "UnstructuredGrid"); }

}  // namespace

bool names_piece(std::string_view file) {
  return is_grid(file) && file.find(kPieceArray) != std::string_view::npos;
}

VtkGroup vtu_tables(const Model& model) {
  VtkGroup group{"FieldData", {}};
  for_each_table([&](const auto& table) {
    const auto& rows = model.*table.rows;
    if (rows.empty()) return;
    for_each_column(table, [&](const auto& column) {
      using Stored = typename std::remove_cvref_t<decltype(column)>::Stored;
      group.arrays.push_back(vtk_array<typename Stored::Type>(
          std::string(column.name), 1, rows.size(),
          [&rows, get = column.get](std::size_t i) { return Stored::store(get(rows[i])); }));
    });
  });
  return group;
}

std::vector<Warning> append_vtu(Sink& sink, VtuGrid grid, Encoding encoding) {
  std::vector<VtkGroup> groups = std::move(grid.fields);
  // A mesh without any provenance has no element for it.
  if (std::all_of(groups.begin(), groups.end(),
                  [](const VtkGroup& group) { return group.arrays.empty(); })) {
    groups.clear();
  }
  const std::size_t points = grid.points.arrays.front().tuples;
  const std::size_t tets = grid.cells.arrays.back().tuples;
  groups.push_back(std::move(grid.points));
  groups.push_back(std::move(grid.cells));
  return append_vtk_file(sink,
                         {.grid_type = "UnstructuredGrid",
                          .counts = "NumberOfPoints=\"" + std::to_string(points) +
                                    "\" NumberOfCells=\"" + std::to_string(tets) + '"',
                          .field_data = std::move(grid.tables),
                          .groups = std::move(groups),
                          .most_unpacked = kGridUnpacked},
                         encoding);
}

extern constinit const Format vtu_format{.name = "vtu",
                                         .summary = "VTK XML unstructured grid",
                                         .extensions = {".vtu"},
                                         .recognise = is_grid,
                                         .read_model = read_vtu_source,
                                         .write_model = write_grid};

}  // namespace tetloft::internal::io

namespace tetloft {

using namespace internal;

Result<void> write_vtu(const std::string& path, const std::vector<Point3>& points,
                       const std::vector<TetVertices>& tets, Encoding encoding) {
  return guard_internal([&]() -> Result<void> {
    const io::Written written =
        io::committed(io::stage(path, nullptr, [&](io::Sink& sink) -> io::Written {
          io::Written done = io::write_mesh(sink, points, tets, encoding);
          if (!done) return io::at_file(path, done.error());
          return done;
        }));
    if (!written) return written.error();
    return {};
  });
}

Result<std::string> format_vtu(const std::vector<Point3>& points,
                               const std::vector<TetVertices>& tets, Encoding encoding) {
  return guard_internal([&]() -> Result<std::string> {
    io::StringSink sink;
    if (io::Written done = io::write_mesh(sink, points, tets, encoding); !done) {
      return done.error();
    }
    return sink.take();
  });
}

}  // namespace tetloft
