// VTK XML poly data (.vtp) by any writer: the tags are scanned, then the arrays that are needed are
// decoded (vtk_data.hpp) and compared with what they announce.
#include "io/vtp_read.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/numbers.hpp"
#include "io/vtk_data.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kDeepest = 64;

// Elements made of points: of each kind how many there are, and their arrays.
enum Kind : std::size_t { kVerts, kLines, kStrips, kPolys, kKinds };
constexpr std::array<std::string_view, kKinds> kGroups{"Verts", "Lines", "Strips", "Polys"};
constexpr std::array<const char*, kKinds> kCounts{"NumberOfVerts", "NumberOfLines",
                                                  "NumberOfStrips", "NumberOfPolys"};

struct Elements {
  std::size_t count = 0;
  std::optional<DataArray> connectivity;
  std::optional<DataArray> offsets;
};

struct Piece {
  std::size_t position = 0;
  std::size_t point_count = 0;
  std::optional<DataArray> points;
  std::array<Elements, kKinds> elements;
  bool tells_sections = false;
};

class VtpScanner {
 public:
  explicit VtpScanner(XmlScanner& scanner) : scanner_(scanner) {}

  Result<void> scan() {
    for (;;) {
      const Result<XmlTag> tag = scanner_.next_tag();
      if (!tag) return tag.error();
      if (tag->kind == XmlTag::Kind::end_of_file) break;
      Result<void> taken = tag->kind == XmlTag::Kind::close ? close(*tag) : open(*tag);
      if (!taken) return taken;
    }
    if (!seen_root_) return scanner_.complain(0, "this is no VTK XML file");
    if (!open_.empty()) {
      return scanner_.complain(scanner_.position(),
                               "the file ends inside of " +
                                   in_quotes('<' + std::string(open_.back()) + '>') +
                                   ": its end is missing");
    }
    return {};
  }

  DataSource source;
  std::vector<Piece> pieces;

 private:
  Result<void> close(const XmlTag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      return scanner_.complain(tag.position, "the tag " +
                                                 in_quotes("</" + std::string(tag.name) + '>') +
                                                 " does not close what is open");
    }
    open_.pop_back();
    return {};
  }

  Result<void> open(const XmlTag& tag) {
    if (open_.empty() && (seen_root_ || tag.name != "VTKFile")) {
      return scanner_.complain(tag.position, seen_root_ ? "something follows the end of the data"
                                                        : "this is no VTK XML file");
    }
    if (open_.size() >= kDeepest) {
      return scanner_.complain(
          tag.position, "the tags are nested more than " + std::to_string(kDeepest) + " deep");
    }
    Result<void> taken = take(tag);
    if (taken && tag.kind == XmlTag::Kind::open) open_.push_back(tag.name);
    return taken;
  }

  Result<void> take(const XmlTag& tag) {
    if (open_.empty()) {
      seen_root_ = true;
      Result<DataSource> declared = declare_source(tag, "PolyData", scanner_);
      if (!declared) return declared.error();
      source = *std::move(declared);
      return {};
    }
    if (tag.name == "AppendedData") return take_appended_data(tag, scanner_, source);
    if (tag.name == "Piece" && open_.back() == "PolyData") return take_piece(tag);
    const bool in_piece = open_.size() > 1 && open_[open_.size() - 2] == "Piece" && !pieces.empty();
    return tag.name == "DataArray" && in_piece ? take_array(tag) : Result<void>();
  }

  Result<void> take_piece(const XmlTag& tag) {
    Piece piece;
    piece.position = tag.position;
    const auto count = [&](const char* key, std::size_t& value) {
      const std::string* const text = tag.find(key);
      if (text == nullptr) return true;
      const auto number = parse_integer(*text);
      if (!number || *number < 0) return false;
      value = static_cast<std::size_t>(*number);
      return true;
    };
    bool valid = count("NumberOfPoints", piece.point_count);
    for (std::size_t k = 0; k < kKinds; ++k) {
      valid = valid && count(kCounts[k], piece.elements[k].count);
    }
    if (!valid) return scanner_.complain(tag.position, "the piece has a count that is none");
    pieces.push_back(std::move(piece));
    return {};
  }

  Result<void> take_array(const XmlTag& tag) {
    Piece& piece = pieces.back();
    const std::string_view group = open_.back();
    const std::string* const name = tag.find("Name");
    if (group == "CellData") {
      piece.tells_sections = piece.tells_sections || (name != nullptr && *name == kSectionOfLine);
      return {};
    }
    if (group == "Points") return declare(tag, "Points", piece.points);
    const auto known = std::find(kGroups.begin(), kGroups.end(), group);
    if (known == kGroups.end() || name == nullptr) return {};
    Elements& elements = piece.elements[static_cast<std::size_t>(known - kGroups.begin())];
    if (*name == "connectivity") return declare(tag, "connectivity", elements.connectivity);
    if (*name == "offsets") return declare(tag, "offsets", elements.offsets);
    return {};
  }

  Result<void> declare(const XmlTag& tag, std::string_view name, std::optional<DataArray>& array) {
    if (array) {
      return scanner_.complain(tag.position,
                               in_quotes(open_.back()) + " has two arrays " + in_quotes(name));
    }
    Result<DataArray> declared = declare_array(tag, name, scanner_);
    if (!declared) return declared.error();
    array = *declared;
    if (tag.kind == XmlTag::Kind::open) array->text = scanner_.take_text();
    return {};
  }

  XmlScanner& scanner_;
  std::vector<std::string_view> open_;
  bool seen_root_ = false;
};

class VtpReader {
 public:
  explicit VtpReader(const Source& source) : scanner_(source.bytes, source.name), file_(scanner_) {}

  Result<void> scan(const std::vector<Kind>& kinds) {
    if (Result<void> scanned = file_.scan(); !scanned) return scanned;
    std::vector<const DataArray*> arrays;
    for (const Piece& piece : file_.pieces) {
      if (piece.points) arrays.push_back(&*piece.points);
      for (const Kind kind : kinds) {
        const Elements& elements = piece.elements[kind];
        if (elements.connectivity) arrays.push_back(&*elements.connectivity);
        if (elements.offsets) arrays.push_back(&*elements.offsets);
      }
    }
    if (Result<void> apart = check_apart(arrays); !apart) return apart;
    return check_unpacking(arrays, file_.source, scanner_);
  }

  [[nodiscard]] bool has(Kind kind) const {
    return std::any_of(file_.pieces.begin(), file_.pieces.end(),
                       [&](const Piece& piece) { return piece.elements[kind].count > 0; });
  }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return file_.pieces; }

  Result<std::vector<Point3>> points_of(const Piece& piece) const {
    std::vector<Point3> points;
    if (!piece.points) {
      if (piece.point_count == 0) return points;
      return scanner_.complain(piece.position, "the piece has no Points");
    }
    const auto values = read_doubles(*piece.points, file_.source, scanner_);
    if (!values) return values.error();
    if (piece.points->components != 3 || values->size() % 3 != 0 ||
        values->size() / 3 != piece.point_count) {
      return scanner_.complain(piece.points->position,
                               "Points has " + std::to_string(values->size()) +
                                   " values where three each are due of " +
                                   std::to_string(piece.point_count) + " points");
    }
    points.reserve(piece.point_count);
    for (std::size_t i = 0; i < values->size(); i += 3) {
      points.push_back({(*values)[i], (*values)[i + 1], (*values)[i + 2]});
      const Point3& p = points.back();
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
      return scanner_.complain(piece.points->position,
                               "point " + std::to_string(i / 3) + " is not finite");
    }
    return points;
  }

  // Calls take(ids) for each element.
  template <class Take>
  Result<void> for_each_element(const Piece& piece, Kind kind, Take&& take) const {
    const Elements& elements = piece.elements[kind];
    if (elements.count == 0) return {};
    if (!elements.connectivity || !elements.offsets) {
      return scanner_.complain(piece.position, in_quotes(kGroups[kind]) +
                                                   " lacks the array 'connectivity' or 'offsets'");
    }
    const auto ids = read_integers(*elements.connectivity, file_.source, scanner_);
    if (!ids) return ids.error();
    const auto offsets = read_integers(*elements.offsets, file_.source, scanner_);
    if (!offsets) return offsets.error();
    if (offsets->size() != elements.count) {
      return scanner_.complain(elements.offsets->position,
                               "offsets has " + std::to_string(offsets->size()) + " values where " +
                                   std::to_string(elements.count) + " are due");
    }
    std::size_t from = 0;
    for (const std::int64_t offset : *offsets) {
      if (offset < 0 || static_cast<std::uint64_t>(offset) < from ||
          static_cast<std::uint64_t>(offset) > ids->size()) {
        return scanner_.complain(elements.offsets->position,
                                 "offsets do not increase within connectivity");
      }
      const auto to = static_cast<std::size_t>(offset);
      for (std::size_t i = from; i < to; ++i) {
        if ((*ids)[i] >= 0 && static_cast<std::uint64_t>((*ids)[i]) < piece.point_count) continue;
        return scanner_.complain(elements.connectivity->position,
                                 "connectivity refers to point " + std::to_string((*ids)[i]) +
                                     " of " + std::to_string(piece.point_count));
      }
      take(std::vector<std::int64_t>(ids->begin() + static_cast<std::ptrdiff_t>(from),
                                     ids->begin() + static_cast<std::ptrdiff_t>(to)));
      from = to;
    }
    return {};
  }

 private:
  // Every byte of the appended data belongs to one array, as in .vtu files.
  Result<void> check_apart(const std::vector<const DataArray*>& arrays) const {
    std::vector<AppendedExtent> extents;
    for (const DataArray* array : arrays) {
      if (const auto extent = appended_extent(*array, file_.source)) extents.push_back(*extent);
    }
    std::sort(extents.begin(), extents.end(),
              [](const auto& a, const auto& b) { return a.from < b.from; });
    for (std::size_t i = 1; i < extents.size(); ++i) {
      if (extents[i].from >= extents[i - 1].to) continue;
      return scanner_.complain(extents[i].array->position,
                               "the array shares appended data with another");
    }
    return {};
  }

  XmlScanner scanner_;
  VtpScanner file_;
};

DrawnLine line_of(const std::vector<std::int64_t>& ids, const std::vector<Point3>& points,
                  bool polygon) {
  DrawnLine line;
  const bool returns = ids.size() > 2 && ids.front() == ids.back();
  line.kind = polygon || returns ? LineKind::closed : LineKind::open;
  const std::size_t n = ids.size() - (returns ? 1 : 0);
  line.points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    line.points.push_back(points[static_cast<std::size_t>(ids[i])]);
  }
  return line;
}

}  // namespace

Result<Drawing> read_vtp_lines(const Source& source, const ReadOptions& /*options*/) {
  VtpReader reader(source);
  if (Result<void> scanned = reader.scan({kLines, kPolys}); !scanned) return scanned.error();
  const Kind kind = reader.has(kLines) ? kLines : kPolys;
  Drawing drawing;
  drawing.structures.emplace_back();
  std::vector<DrawnLine>& lines = drawing.structures.front().lines;
  bool level = true;
  for (const Piece& piece : reader.pieces()) {
    const Result<std::vector<Point3>> points = reader.points_of(piece);
    if (!points) return points.error();
    level = level && piece.tells_sections;
    Result<void> taken = reader.for_each_element(piece, kind, [&](const auto& ids) {
      if (ids.empty()) return;
      lines.push_back(line_of(ids, *points, kind == kPolys));
      for (const Point3& p : lines.back().points) {
        level = level && p.z == lines.back().points.front().z;
      }
    });
    if (!taken) return taken.error();
  }
  if (lines.empty()) {
    Error error{ErrorCode::invalid_input, "the file has neither lines nor polygons", {}};
    error.where.file = source.name;
    return error;
  }
  // Files of stacks tell sections apart, however near they are.
  drawing.exact_heights = level;
  std::size_t others = 0;
  for (const Piece& piece : reader.pieces()) {
    if (kind == kLines) others += piece.elements[kPolys].count;
    others += piece.elements[kStrips].count;
  }
  if (others > 0) {
    drawing.warnings.push_back(
        {"left out: " + std::to_string(others) + " polygons and strips beside the lines", {}});
  }
  return drawing;
}

Result<ReadPoints> read_vtp_points(const Source& source, const ReadOptions& /*options*/) {
  VtpReader reader(source);
  if (Result<void> scanned = reader.scan({}); !scanned) return scanned.error();
  ReadPoints read;
  for (const Piece& piece : reader.pieces()) {
    const Result<std::vector<Point3>> points = reader.points_of(piece);
    if (!points) return points.error();
    read.points.insert(read.points.end(), points->begin(), points->end());
  }
  return read;
}

}  // namespace tetloft::internal::io
