// Points in space as lines "x y z", or rows of a table of which other columns are left out.
#include <array>
#include <string>

#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/table_rows.hpp"

namespace tetloft::internal::io {

namespace {

class PointTable {
 public:
  explicit PointTable(const Source& source) : rows_(source.bytes), name_(source.name) {}

  Result<ReadPoints> read() {
    bool more = rows_.next();
    // The second names are those of other programs.
    const std::array<std::vector<std::string_view>, 3> kColumnNames{
        {{"x", "points0", "easting"},
         {"y", "points1", "northing"},
         {"z", "points2", "height", "elevation"}}};
    if (more && rows_.is_header() && may_be_names()) {
      for (std::size_t i = 0; i < 3; ++i) {
        columns_[i] = column_named(rows_.fields(), kColumnNames[i]);
        if (columns_[i] < rows_.fields().size()) continue;
        return row_error(name_, rows_.line(),
                         "no columns named x, y and z (or easting, northing and height): name them "
                         "in the first row, or leave it out");
      }
      more = rows_.next();
    }
    for (; more; more = rows_.next()) {
      if (Result<void> taken = take_row(); !taken) return taken.error();
    }
    if (others_ > 0) {
      Warning warning{"left out: " + std::to_string(others_) +
                          (others_ == 1 ? " column" : " columns") + " beside x, y and z",
                      {}};
      warning.where.file = name_;
      read_.warnings.push_back(std::move(warning));
    }
    return std::move(read_);
  }

 private:
  // A row of which no field is a number: else a number is wrong.
  bool may_be_names() const {
    for (const std::string_view field : rows_.fields()) {
      if (rows_.number(field).status != NumberStatus::malformed) return false;
    }
    return rows_.fields().size() > 2;
  }

  Result<void> take_row() {
    const std::vector<std::string_view>& fields = rows_.fields();
    if (fields.size() < 3) return row_form_error(name_, rows_.line(), "x y z", fields.size());
    if (read_.points.empty()) count_ = fields.size();
    if (fields.size() != count_) {
      return row_error(
          name_, rows_.line(),
          std::to_string(count_) + " fields are due, here are " + std::to_string(fields.size()));
    }
    others_ = count_ - 3;
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view field = columns_[i] < count_ ? fields[columns_[i]] : "";
      const ParsedNumber number = rows_.number(field);
      if (!number.ok()) return row_error(name_, rows_.line(), complaint(field, number.status));
      xyz[i] = number.value;
    }
    read_.points.push_back({xyz[0], xyz[1], xyz[2]});
    return {};
  }

  TableRows rows_;
  const std::string& name_;
  std::array<std::size_t, 3> columns_{0, 1, 2};
  std::size_t count_ = 3;   // of fields in a row
  std::size_t others_ = 0;  // that are left out
  ReadPoints read_;
};

Result<ReadPoints> read_xyz(const Source& source, const ReadOptions& /*options*/) {
  return PointTable(source).read();
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

extern constinit const Format xyz_format{
    .name = "xyz",
    .summary = "lines \"x y z\" with # comments, tables with such columns",
    .extensions = {".xyz", ".txt", ".csv", ".tsv"},
    .takes_text = true,
    .read_points = read_xyz,
    .write_points = write_xyz};

}  // namespace tetloft::internal::io
