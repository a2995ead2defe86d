// Line segments as .vtp.
#include <cstdint>
#include <string>
#include <utility>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/numbers.hpp"
#include "io/stage.hpp"
#include "io/vtk_write.hpp"

namespace tetloft {

Result<io::PendingFile> io::stage_lines(const std::string& path, const LineSet& lines,
                                        Encoding encoding, TemporaryWatcher* watcher) {
  return guard_internal([&]() -> Result<PendingFile> {
    const std::size_t n = lines.lines.size();
    io::VtkGroup cell_data{"CellData", {}};
    for (const LineSet::Array& array : lines.data) {
      if (array.value.size() != n) {
        Error error{ErrorCode::invalid_input,
                    "array " + io::in_quotes(array.name) + " has " +
                        std::to_string(array.value.size()) + " values for " + std::to_string(n) +
                        " lines",
                    {}};
        error.where.file = path;
        return error;
      }
      cell_data.arrays.push_back(io::vtk_array<std::int32_t>(
          array.name, 1, n, [&array](std::size_t i) { return array.value[i]; }));
    }
    io::VtkGroup points{"Points", {}};
    points.arrays.push_back(io::vtk_array<double>("Points", 3, 6 * n, [&](std::size_t i) {
      const Point3& p = lines.lines[i / 6][i / 3 % 2];
      return i % 3 == 0 ? p.x : i % 3 == 1 ? p.y : p.z;
    }));
    io::VtkGroup cells{"Lines", {}};
    cells.arrays.push_back(io::vtk_array<std::int64_t>(
        "connectivity", 1, 2 * n, [](std::size_t i) { return static_cast<std::int64_t>(i); }));
    cells.arrays.push_back(io::vtk_array<std::int64_t>(
        "offsets", 1, n, [](std::size_t i) { return static_cast<std::int64_t>(2 * (i + 1)); }));
    io::PendingFile file(path, watcher);
    io::append_vtk_file(file, "PolyData",
                        "NumberOfPoints=\"" + std::to_string(2 * n) +
                            "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(n) +
                            "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"",
                        {cell_data, points, cells}, encoding);
    return finished(std::move(file));
  });
}

Result<void> write_lines(const std::string& path, const LineSet& lines, Encoding encoding) {
  return io::committed(io::stage_lines(path, lines, encoding));
}

}  // namespace tetloft
