// The boundary surface of a model as .obj, .ply, .vtp or .stl.
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/arguments.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"
#include "io/stage.hpp"
#include "io/stl_write.hpp"
#include "io/surface.hpp"
#include "io/vtk_write.hpp"
#include "model/fields.hpp"
#include "model/well_formed.hpp"

namespace tetloft {

namespace io {

SurfaceMesh surface_mesh(const Model& model) {
  Surface surface = boundary_surface(model);
  SurfaceMesh mesh;
  mesh.tet = std::move(surface.tet);
  // New number of each model vertex; 0 of those that are not on the surface.
  IdVector<VertexId, std::uint32_t> number(model.points.size(), 0);
  for (const TriangleVertices& triangle : surface.triangles) {
    for (const VertexId v : triangle) number[v] = 1;
  }
  for (VertexId v(0); v < model.points.end_id(); v = VertexId(v.index() + 1)) {
    if (number[v] == 0) continue;
    number[v] = static_cast<std::uint32_t>(mesh.vertex.size());
    mesh.vertex.push_back(v);
    mesh.points.push_back(model.points[v]);
  }
  mesh.triangles.reserve(surface.triangles.size());
  for (const TriangleVertices& t : surface.triangles) {
    mesh.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  return mesh;
}

namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16;

void flush_if_large(PendingFile& file, std::string& piece) {
  if (piece.size() < kPiece) return;
  file.append(piece);
  piece.clear();
}

void append_point(std::string& text, const Point3& p) {
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
  append_number(text, p.z);
}

void append_obj(PendingFile& file, const SurfaceMesh& mesh) {
  std::string piece;
  for (const Point3& p : mesh.points) {
    piece += "v ";
    append_point(piece, p);
    piece += '\n';
    flush_if_large(file, piece);
  }
  for (const auto& triangle : mesh.triangles) {
    piece += 'f';
    for (const std::uint32_t v : triangle) {
      piece += ' ';
      append_number(piece, std::uint64_t{v} + 1);  // OBJ counts from 1
    }
    piece += '\n';
    flush_if_large(file, piece);
  }
  file.append(piece);
}

void append_ply(PendingFile& file, const SurfaceMesh& mesh, Encoding encoding) {
  const bool ascii = encoding == Encoding::ascii;
  std::string piece = "ply\nformat ";
  piece += ascii ? "ascii" : "binary_little_endian";
  piece += " 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
           std::to_string(mesh.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point3& p : mesh.points) {
    if (ascii) {
      append_point(piece, p);
      piece += '\n';
    } else {
      for (const double c : {p.x, p.y, p.z}) append_little(piece, c);
    }
    flush_if_large(file, piece);
  }
  for (const auto& triangle : mesh.triangles) {
    if (ascii) {
      piece += '3';
      for (const std::uint32_t v : triangle) {
        piece += ' ';
        append_number(piece, v);
      }
      piece += '\n';
    } else {
      append_little(piece, std::uint8_t{3});
      for (const std::uint32_t v : triangle) append_little(piece, v);
    }
    flush_if_large(file, piece);
  }
  file.append(piece);
}

void append_vtp(PendingFile& file, const SurfaceMesh& mesh, const Model& model, Encoding encoding) {
  const std::size_t points = mesh.points.size();
  const std::size_t triangles = mesh.triangles.size();
  VtkGroup point_data{"PointData", {}};
  VtkGroup cell_data{"CellData", {}};
  for_each_field([&](const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    const auto& values = model.*field.values;
    if (!field.on_surfaces || values.empty()) return;
    const auto& index = [&]() -> const auto& {
      if constexpr (Field::kOfPoints) {
        return mesh.vertex;
      } else {
        return mesh.tet;
      }
    }
    ();
    VtkGroup& group = Field::kOfPoints ? point_data : cell_data;
    group.arrays.push_back(vtk_array<typename Field::Stored::Type>(
        std::string(field.name), 1, index.size(),
        [&values, &index](std::size_t i) { return Field::Stored::store(values[index[i]]); }));
  });
  VtkGroup coordinates{"Points", {}};
  coordinates.arrays.push_back(vtk_array<double>("Points", 3, 3 * points, [&](std::size_t i) {
    const Point3& p = mesh.points[i / 3];
    return i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
  }));
  VtkGroup polys{"Polys", {}};
  polys.arrays.push_back(vtk_array<std::int64_t>(
      "connectivity", 1, 3 * triangles,
      [&](std::size_t i) { return static_cast<std::int64_t>(mesh.triangles[i / 3][i % 3]); }));
  polys.arrays.push_back(vtk_array<std::int64_t>("offsets", 1, triangles, [](std::size_t i) {
    return static_cast<std::int64_t>(3 * (i + 1));
  }));
  append_vtk_file(file, "PolyData",
                  "NumberOfPoints=\"" + std::to_string(points) +
                      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
                      "NumberOfPolys=\"" +
                      std::to_string(triangles) + '"',
                  {point_data, cell_data, coordinates, polys}, encoding);
}

}  // namespace

}  // namespace io

Result<io::StagedSurface> io::stage_surface(const std::string& path, const Model& model,
                                            Encoding encoding, TemporaryWatcher* watcher) {
  return guard_internal([&]() -> Result<StagedSurface> {
    const std::string extension = io::extension_of(path);
    const bool stl = extension == ".stl";
    if (!stl && extension != ".obj" && extension != ".ply" && extension != ".vtp") {
      Error error{ErrorCode::usage,
                  "a surface is written as .obj, .ply, .vtp or .stl, not " +
                      (extension.empty() ? "without extension" : "as " + io::in_quotes(extension)),
                  {}};
      error.where.file = path;
      return error;
    }
    if (Result<void> known = io::check_encoding(encoding); !known) return known.error();
    if (Result<void> formed = check_well_formed(model); !formed) {
      return io::at_file(path, formed);
    }
    const io::SurfaceMesh mesh = io::surface_mesh(model);
    std::vector<Warning> warnings;
    if (stl) {
      Result<std::vector<Warning>> checked = io::check_float32(mesh, path);
      if (!checked) return checked.error();
      warnings = *std::move(checked);
    }
    io::PendingFile file(path, watcher);
    if (extension == ".obj") io::append_obj(file, mesh);
    if (extension == ".ply") io::append_ply(file, mesh, encoding);
    if (extension == ".vtp") io::append_vtp(file, mesh, model, encoding);
    if (stl) io::append_stl(file, mesh, encoding);
    if (Result<void> written = file.finish(); !written) return written.error();
    return StagedSurface{std::move(file), std::move(warnings)};
  });
}

Result<std::vector<Warning>> write_surface(const std::string& path, const Model& model,
                                           Encoding encoding) {
  Result<io::StagedSurface> staged = io::stage_surface(path, model, encoding);
  if (!staged) return staged.error();
  if (Result<void> written = staged->file.commit(); !written) return written.error();
  return std::move(staged->warnings);
}

}  // namespace tetloft
