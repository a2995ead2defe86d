// Contours as rows of text, a point each: x, y, z, and the contour, section or structure that it
// belongs to. CsvColumns are known by their names; without names they are x, y, z and the contour.
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/table_rows.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

// Where what stands; kNowhere: nowhere.
struct CsvColumns {
  std::array<std::size_t, 3> xyz{0, 1, 2};
  std::size_t contour = kNowhere;
  std::size_t section = kNowhere;
  std::size_t structure = kNowhere;
  std::size_t count = 0;
};

std::size_t column_or_none(const std::vector<std::string_view>& fields,
                           const std::vector<std::string_view>& names) {
  const std::size_t found = column_named(fields, names);
  return found == fields.size() ? kNowhere : found;
}

CsvColumns columns_by_name(const std::vector<std::string_view>& names) {
  CsvColumns columns;
  columns.xyz = {column_or_none(names, {"x", "px", "points0", "xcoord", "coordx", "xmm", "xum",
                                        "xm", "easting", "lon", "longitude"}),
                 column_or_none(names, {"y", "py", "points1", "ycoord", "coordy", "ymm", "yum",
                                        "ym", "northing", "lat", "latitude"}),
                 column_or_none(names, {"z", "pz", "points2", "zcoord", "coordz", "zmm", "zum",
                                        "zm", "height", "elevation", "elev", "altitude"})};
  columns.contour = column_or_none(
      names, {"contour", "contourid", "contournumber", "contourindex", "loop", "loopid", "ring",
              "ringid", "polygon", "polygonid", "curve", "line", "lineid", "part", "id"});
  columns.section = column_or_none(names, {"section", "sectionid", "slice", "sliceid",
                                           "slicenumber", "layer", "plane", "level"});
  columns.structure = column_or_none(names, {"structure", "structurename", "name", "object",
                                             "objectid", "roi", "roiname", "organ", "label"});
  columns.count = names.size();
  return columns;
}

// Tables of contours; tables of points alone are for whoever reads points.
bool is_contour_table(std::string_view bytes) {
  TableRows rows(bytes.substr(0, 4096));
  if (!rows.next() || !rows.is_header()) return false;
  const CsvColumns columns = columns_by_name(rows.fields());
  const bool groups =
      columns.contour != kNowhere || columns.section != kNowhere || columns.structure != kNowhere;
  return columns.xyz[0] != kNowhere && columns.xyz[1] != kNowhere && groups;
}

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& name) : rows_(text), name_(name) {}

  Result<Drawing> read() {
    bool more = rows_.next();
    if (!more) return row_error(name_, rows_.line(), "the file is empty");
    if (rows_.is_header()) {
      if (Result<void> known = take_header(); !known) return known.error();
      more = rows_.next();
    } else if (Result<void> known = count_columns(); !known) {
      return known.error();
    }
    for (; more; more = rows_.next()) {
      if (Result<void> taken = take_row(); !taken) return taken.error();
    }
    finish_contour();
    if (drawing_.structures.empty())
      return row_error(name_, rows_.line(), "the file has no points");
    drawing_.apart = drawing_.structures.size() > 1;
    return std::move(drawing_);
  }

 private:
  Result<void> take_header() {
    columns_ = columns_by_name(rows_.fields());
    if (columns_.xyz[0] == kNowhere || columns_.xyz[1] == kNowhere) {
      return row_error(name_, rows_.line(),
                       "no columns named x and y: " + std::to_string(rows_.fields().size()) +
                           " names, the first of them " + in_quotes(rows_.fields().front()));
    }
    if (columns_.xyz[2] == kNowhere) columns_.xyz[2] = columns_.section;
    if (columns_.xyz[2] == kNowhere) {
      return row_error(name_, rows_.line(),
                       "no column named z, height or section tells the planes");
    }
    const std::array<std::size_t, 6> used{columns_.xyz[0],  columns_.xyz[1],  columns_.xyz[2],
                                          columns_.contour, columns_.section, columns_.structure};
    std::string others;
    for (std::size_t i = 0; i < rows_.fields().size() && others.size() < kLongestList; ++i) {
      if (std::find(used.begin(), used.end(), i) != used.end()) continue;
      others += (others.empty() ? "" : ", ") + in_quotes(rows_.fields()[i]);
    }
    if (!others.empty()) {
      drawing_.warnings.push_back({"columns that are not used: " + others, {}});
    }
    return {};
  }

  Result<void> count_columns() {
    columns_.count = rows_.fields().size();
    if (columns_.count == 3) return {};
    if (columns_.count == 4) {
      columns_.contour = 3;
      return {};
    }
    return row_error(name_, rows_.line(),
                     "rows without names of columns are x, y, z, or x, y, z and the contour; this "
                     "one has " +
                         std::to_string(columns_.count) +
                         " fields: name the columns in a first row");
  }

  Result<void> take_row() {
    const std::vector<std::string_view>& fields = rows_.fields();
    if (fields.size() != columns_.count) {
      return row_error(name_, rows_.line(),
                       std::to_string(columns_.count) + " fields are due, here are " +
                           std::to_string(fields.size()));
    }
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view field = fields[columns_.xyz[i]];
      const ParsedNumber number = rows_.number(field);
      if (!number.ok()) return row_error(name_, rows_.line(), complaint(field, number.status));
      xyz[i] = number.value;
    }
    const auto text = [&](std::size_t column) {
      return column == kNowhere ? std::string_view() : fields[column];
    };
    const bool begins = line_.points.empty() || rows_.after_gap() ||
                        text(columns_.structure) != structure_ ||
                        text(columns_.contour) != contour_ || text(columns_.section) != section_ ||
                        (!by_number() && xyz[2] != line_.points.back().z);
    if (begins) {
      finish_contour();
      if (alone_ > kMostAlone) {
        return row_error(name_, rows_.line(),
                         "more than " + std::to_string(kMostAlone) +
                             " points stand alone, with another contour or height before and "
                             "behind them: these rows are no contours");
      }
      line_.line = rows_.line();
      structure_ = text(columns_.structure);
      contour_ = text(columns_.contour);
      section_ = text(columns_.section);
    }
    line_.points.push_back({xyz[0], xyz[1], xyz[2]});
    lines_of_points_.push_back(rows_.line());
    return {};
  }

  // Contours of which the numbers begin anew in each section are told apart by z. Where z hardly
  // stays the same from point to point, it is a contour of an oblique plane.
  void finish_contour() {
    if (line_.points.empty()) return;
    const std::vector<Point3>& points = line_.points;
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i].z != points[i - 1].z) begins.push_back(i);
    }
    begins.push_back(points.size());
    bool splits = true;
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      splits = splits && begins[k + 1] - begins[k] >= 3;
    }
    if (!splits) begins = {0, points.size()};
    std::vector<DrawnLine>& lines = structure().lines;
    for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
      DrawnLine line;
      line.line = lines_of_points_[begins[k]];
      if (begins[k + 1] - begins[k] == 1) ++alone_;
      line.points.assign(points.begin() + static_cast<std::ptrdiff_t>(begins[k]),
                         points.begin() + static_cast<std::ptrdiff_t>(begins[k + 1]));
      lines.push_back(std::move(line));
    }
    line_.points.clear();
    lines_of_points_.clear();
  }

  // Else contours are told apart by their heights.
  [[nodiscard]] bool by_number() const {
    return columns_.contour != kNowhere || columns_.section != kNowhere;
  }

  DrawnStructure& structure() {
    const auto known = structure_ids_.emplace(structure_, drawing_.structures.size());
    if (known.second) {
      DrawnStructure made;
      made.number = static_cast<std::int64_t>(drawing_.structures.size());
      made.name = structure_;
      drawing_.structures.push_back(std::move(made));
    }
    return drawing_.structures[known.first->second];
  }

  static constexpr std::size_t kLongestList = 200;
  static constexpr std::size_t kMostAlone = 10'000;

  TableRows rows_;
  const std::string& name_;
  CsvColumns columns_;
  Drawing drawing_;
  DrawnLine line_;  // that is read
  std::vector<std::size_t> lines_of_points_;
  std::string structure_, contour_, section_;  // of it
  std::map<std::string, std::size_t> structure_ids_;
  std::size_t alone_ = 0;  // contours of one point
};

Result<Drawing> read_csv(const Source& source, const ReadOptions& /*options*/) {
  return CsvReader(source.bytes, source.name).read();
}

}  // namespace

extern constinit const Format csv_format{.name = "csv",
                                         .summary = "rows of x, y, z and the contour",
                                         .extensions = {".csv", ".tsv", ".xyz"},
                                         .recognise = is_contour_table,
                                         .read_drawing = read_csv};

}  // namespace tetloft::internal::io
