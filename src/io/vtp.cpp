// VTK XML poly data (.vtp): boundary surfaces, lines in space, and contours.
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "io/drawing/written_stack.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/vtk_data.hpp"
#include "io/vtk_text.hpp"
#include "io/vtk_write.hpp"
#include "io/vtp_read.hpp"
#include "model/fields.hpp"

namespace tetloft::internal::io {

namespace {

bool is_poly_data(std::string_view bytes) { return is_vtk_file(bytes, "PolyData"); }

// How many elements there are of each kind that poly data have.
std::string poly_counts(std::size_t points, std::size_t lines, std::size_t polygons) {
  return "NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
         std::to_string(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(polygons) + '"';
}

// "offsets" of `n` elements of `corners` points each.
VtkArray offset_array(std::size_t n, std::size_t corners) {
  return vtk_array<std::int64_t>("offsets", 1, n, [corners](std::size_t i) {
    return static_cast<std::int64_t>(corners * (i + 1));
  });
}

// The fields that surfaces keep, of points or of triangles.
template <bool kOfPoints, class Index>
VtkGroup surface_fields(const char* element, const Model& model, const Index& index) {
  VtkGroup group{element, {}};
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (Field::kOfPoints == kOfPoints) {
      const auto& values = model.*field.values;
      if (!field.on_surfaces || values.empty()) return;
      group.arrays.push_back(vtk_array<typename Field::Stored::Type>(
          std::string(field.name), 1, index.size(),
          [&values, &index](std::size_t i) { return Field::Stored::store(values[index[i]]); }));
    }
  });
  return group;
}

Written write_surface_vtp(Sink& sink, const SurfaceMesh& mesh, const Model& model,
                          const Target& target) {
  const std::size_t triangles = mesh.triangles.size();
  VtkGroup polys{"Polys", {}};
  polys.arrays.push_back(vtk_array<std::int64_t>(
      "connectivity", 1, 3 * triangles,
      [&](std::size_t i) { return static_cast<std::int64_t>(mesh.triangles[i / 3][i % 3]); }));
  polys.arrays.push_back(offset_array(triangles, 3));
  VtkGroup texts{"FieldData", {}};
  add_texts(model, texts);
  return append_vtk_file(
      sink,
      {.grid_type = "PolyData",
       .counts = poly_counts(mesh.points.size(), 0, triangles),
       .field_data = std::move(texts),
       .groups = {surface_fields<true>("PointData", model, mesh.vertex),
                  surface_fields<false>("CellData", model, mesh.tet),
                  vtk_points(mesh.points.size(),
                             [&](std::size_t i) -> const Point3& { return mesh.points[i]; }),
                  polys},
       .most_unpacked = kPolyDataUnpacked},
      target.options.encoding);
}

Written write_lines_vtp(Sink& sink, const LineSet& lines, const Target& target) {
  const std::size_t n = lines.lines.size();
  VtkGroup cell_data{"CellData", {}};
  for (const LineSet::Array& array : lines.data) {
    if (array.value.size() != n) {
      return Error{ErrorCode::invalid_input,
                   "array " + in_quotes(array.name) + " has " + std::to_string(array.value.size()) +
                       " values for " + std::to_string(n) + " lines",
                   {}};
    }
    cell_data.arrays.push_back(vtk_array<std::int32_t>(
        array.name, 1, n, [&array](std::size_t i) { return array.value[i]; }));
  }
  VtkGroup cells{"Lines", {}};
  cells.arrays.push_back(vtk_array<std::int64_t>(
      "connectivity", 1, 2 * n, [](std::size_t i) { return static_cast<std::int64_t>(i); }));
  cells.arrays.push_back(offset_array(n, 2));
  return append_vtk_file(sink,
                         {.grid_type = "PolyData",
                          .counts = poly_counts(2 * n, n, 0),
                          .groups = {cell_data,
                                     vtk_points(2 * n,
                                                [&](std::size_t i) -> const Point3& {
                                                  return lines.lines[i / 2][i % 2];
                                                }),
                                     cells},
                          .most_unpacked = kPolyDataUnpacked},
                         target.options.encoding);
}

// Closed polylines: of each contour its points, and the first id once more.
Written write_stack_vtp(Sink& sink, const SectionStack& stack, const Target& target) {
  const Result<std::vector<Warning>> fit = check_written(stack, target);
  if (!fit) return fit.error();
  std::vector<Point3> points;
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> ends;
  std::vector<std::int32_t> section_of;
  std::int32_t written = 0;  // sections: those without contours are not
  for (const Section& section : stack.sections) {
    if (section.contours.empty()) continue;
    for (const Contour& contour : section.contours) {
      const auto first = static_cast<std::int64_t>(points.size());
      for (const Point2& p : contour.vertices) {
        ids.push_back(static_cast<std::int64_t>(points.size()));
        points.push_back(place(stack.frame, {p.x, p.y, section.z}));
      }
      ids.push_back(first);
      ends.push_back(static_cast<std::int64_t>(ids.size()));
      section_of.push_back(written);
    }
    ++written;
  }
  VtkGroup cell_data{"CellData", {}};
  cell_data.arrays.push_back(vtk_array<std::int32_t>(kSectionOfLine, 1, section_of.size(),
                                                     [&](std::size_t i) { return section_of[i]; }));
  VtkGroup cells{"Lines", {}};
  cells.arrays.push_back(vtk_array<std::int64_t>("connectivity", 1, ids.size(),
                                                 [&](std::size_t i) { return ids[i]; }));
  cells.arrays.push_back(
      vtk_array<std::int64_t>("offsets", 1, ends.size(), [&](std::size_t i) { return ends[i]; }));
  std::vector<Warning> warnings = append_vtk_file(
      sink,
      {.grid_type = "PolyData",
       .counts = poly_counts(points.size(), ends.size(), 0),
       .groups = {cell_data,
                  vtk_points(points.size(),
                             [&](std::size_t i) -> const Point3& { return points[i]; }),
                  cells},
       .most_unpacked = kPolyDataUnpacked},
      target.options.encoding);
  warnings.insert(warnings.begin(), fit->begin(), fit->end());
  return warnings;
}

}  // namespace

extern constinit const Format vtp_format{.name = "vtp",
                                         .summary = "VTK XML poly data",
                                         .extensions = {".vtp"},
                                         .recognise = is_poly_data,
                                         .read_drawing = read_vtp_lines,
                                         .read_points = read_vtp_points,
                                         .read_triangles = read_vtp_triangles,
                                         .write_stack = write_stack_vtp,
                                         .write_surface = write_surface_vtp,
                                         .write_lines = write_lines_vtp};

}  // namespace tetloft::internal::io
