// Polyhedra as VTK XML unstructured grids (.vtu): of each cell its points, and its faces as a
// stream of counts and points.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <tetloft/io.hpp>

#include "core/guard.hpp"
#include "core/text.hpp"
#include "io/arguments.hpp"
#include "io/stage.hpp"
#include "io/vtk_data.hpp"
#include "io/vtk_text.hpp"
#include "io/vtk_write.hpp"
#include "io/vtu_frame.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::uint8_t kVtkPolyhedron = 42;

// The arrays of the element Cells.
struct CellStreams {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> faces;
  std::vector<std::int64_t> face_offsets;
};

CellStreams streams_of(const PolyhedronSet& polyhedra) {
  CellStreams streams;
  std::vector<std::int64_t> corners;
  for (const std::vector<PolyhedronSet::Face>& cell : polyhedra.cells) {
    corners.clear();
    streams.faces.push_back(static_cast<std::int64_t>(cell.size()));
    for (const PolyhedronSet::Face& face : cell) {
      streams.faces.push_back(static_cast<std::int64_t>(face.size()));
      streams.faces.insert(streams.faces.end(), face.begin(), face.end());
      corners.insert(corners.end(), face.begin(), face.end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    streams.connectivity.insert(streams.connectivity.end(), corners.begin(), corners.end());
    streams.offsets.push_back(static_cast<std::int64_t>(streams.connectivity.size()));
    streams.face_offsets.push_back(static_cast<std::int64_t>(streams.faces.size()));
  }
  return streams;
}

Result<void> check_polyhedra(const PolyhedronSet& polyhedra) {
  const std::size_t n = polyhedra.cells.size();
  for (const PolyhedronSet::Array& array : polyhedra.data) {
    if (array.value.size() == n) continue;
    return Error{ErrorCode::invalid_input,
                 "array " + in_quotes(array.name) + " has " + std::to_string(array.value.size()) +
                     " values for " + std::to_string(n) + " polyhedra",
                 {}};
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (const PolyhedronSet::Face& face : polyhedra.cells[i]) {
      const bool known = std::all_of(face.begin(), face.end(), [&](std::uint32_t corner) {
        return corner < polyhedra.points.size();
      });
      if (known) continue;
      return Error{ErrorCode::invalid_input,
                   "polyhedron " + std::to_string(i) + " has a corner that is no point",
                   {}};
    }
  }
  return {};
}

VtkArray numbers_array(const char* name, const std::vector<std::int64_t>& values) {
  return vtk_array<std::int64_t>(name, 1, values.size(),
                                 [&values](std::size_t i) { return values[i]; });
}

Written write_polyhedra_vtu(Sink& sink, const PolyhedronSet& polyhedra, Encoding encoding) {
  if (Result<void> known = check_encoding(encoding); !known) return known.error();
  if (Result<void> formed = check_polyhedra(polyhedra); !formed) return formed.error();
  const std::size_t n = polyhedra.cells.size();
  const CellStreams streams = streams_of(polyhedra);
  VtkGroup data{"CellData", {}};
  for (const PolyhedronSet::Array& array : polyhedra.data) {
    data.arrays.push_back(
        vtk_array<double>(array.name, 1, n, [&array](std::size_t i) { return array.value[i]; }));
  }
  VtkGroup cells{"Cells", {}};
  cells.arrays.push_back(numbers_array("connectivity", streams.connectivity));
  cells.arrays.push_back(numbers_array("offsets", streams.offsets));
  cells.arrays.push_back(
      vtk_array<std::uint8_t>("types", 1, n, [](std::size_t) { return kVtkPolyhedron; }));
  cells.arrays.push_back(numbers_array("faces", streams.faces));
  cells.arrays.push_back(numbers_array("faceoffsets", streams.face_offsets));
  const std::vector<Point3>& points = polyhedra.points;
  return append_vtk_file(
      sink,
      {.grid_type = "UnstructuredGrid",
       .counts = "NumberOfPoints=\"" + std::to_string(points.size()) + "\" NumberOfCells=\"" +
                 std::to_string(n) + '"',
       .field_data = {},
       .groups = {data,
                  vtk_points(points.size(),
                             [&points](std::size_t i) -> const Point3& { return points[i]; }),
                  cells},
       .most_unpacked = kGridUnpacked},
      encoding);
}

}  // namespace

Result<Staged> stage_polyhedra(const std::string& path, const PolyhedronSet& polyhedra,
                               Encoding encoding, TemporaryWatcher* watcher) {
  return guard_internal([&] {
    return stage(path, watcher, [&](Sink& sink) -> Written {
      Written done = write_polyhedra_vtu(sink, polyhedra, encoding);
      if (!done) return at_file(path, done.error());
      return done;
    });
  });
}

}  // namespace tetloft::internal::io

namespace tetloft {

using namespace internal;

Result<void> write_polyhedra(const std::string& path, const PolyhedronSet& polyhedra,
                             Encoding encoding) {
  return guard_internal([&]() -> Result<void> {
    const io::Written written = io::committed(io::stage_polyhedra(path, polyhedra, encoding));
    if (!written) return written.error();
    return {};
  });
}

Result<std::string> format_polyhedra(const PolyhedronSet& polyhedra, Encoding encoding) {
  return guard_internal([&]() -> Result<std::string> {
    io::StringSink sink;
    if (io::Written done = io::write_polyhedra_vtu(sink, polyhedra, encoding); !done) {
      return done.error();
    }
    return sink.take();
  });
}

}  // namespace tetloft
