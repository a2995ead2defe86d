// Points in space as lines "x y z".
#include <array>
#include <string>

#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

Result<ReadPoints> read_xyz(const Source& source, const ReadOptions& /*options*/) {
  ReadPoints read;
  const auto take = [&](std::size_t line, const RowFields& fields) -> Result<void> {
    if (fields.count != 3) return row_form_error(source.name, line, "x y z", fields.count);
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const ParsedNumber number = parse_number(fields.field[i]);
      if (!number.ok()) {
        return row_error(source.name, line, complaint(fields.field[i], number.status));
      }
      xyz[i] = number.value;
    }
    read.points.push_back({xyz[0], xyz[1], xyz[2]});
    return {};
  };
  Result<void> rows = for_each_row(source.bytes, take);
  if (!rows) return rows.error();
  return read;
}

Written write_xyz(Sink& sink, const std::vector<Point3>& points, const Target& /*target*/) {
  Pieces pieces(sink);
  for (const Point3& p : points) {
    append_point(pieces.text(), p);
    pieces.text() += '\n';
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format xyz_format{.name = "xyz",
                                         .summary = "lines \"x y z\" with # comments",
                                         .extensions = {".xyz", ".txt"},
                                         .takes_text = true,
                                         .read_points = read_xyz,
                                         .write_points = write_xyz};

}  // namespace tetloft::internal::io
