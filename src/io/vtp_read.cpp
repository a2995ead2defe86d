// VTK XML poly data (.vtp) by any writer: the tags are scanned, then the arrays that are needed are
// decoded (vtk_data.hpp) and compared with what they announce.
#include "io/vtp_read.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/numbers.hpp"
#include "io/polygons.hpp"
#include "io/vtk_data.hpp"
#include "io/xml.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::size_t kDeepestTags = 64;

// Elements made of points: of each kind how many there are, and their arrays.
enum ElementKind : std::size_t { kVerts, kLines, kStrips, kPolys, kKinds };
constexpr std::array<std::string_view, kKinds> kElementGroups{"Verts", "Lines", "Strips", "Polys"};
constexpr std::array<const char*, kKinds> kCounts{"NumberOfVerts", "NumberOfLines",
                                                  "NumberOfStrips", "NumberOfPolys"};

enum class VtpRole : std::uint8_t { points, connectivity, offsets };

struct VtpPiece {
  std::size_t position = 0;
  std::size_t points = 0;
  std::array<std::size_t, kKinds> count{};
  std::size_t first_array = 0;  // its arrays end where those of the next piece begin
  bool tells_sections = false;
};

struct VtpArray {
  VtpRole role = VtpRole::points;
  ElementKind kind = kKinds;  // of elements
  DataArray data;
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

  // The array of a piece, or null.
  [[nodiscard]] const DataArray* find(std::size_t piece, VtpRole role,
                                      ElementKind kind = kKinds) const {
    const std::size_t end =
        piece + 1 < pieces.size() ? pieces[piece + 1].first_array : arrays.size();
    for (std::size_t i = pieces[piece].first_array; i < end; ++i) {
      if (arrays[i].role == role && arrays[i].kind == kind) return &arrays[i].data;
    }
    return nullptr;
  }

  DataSource source;
  std::vector<VtpPiece> pieces;
  std::vector<VtpArray> arrays;

 private:
  Result<void> close(const XmlTag& tag) {
    if (open_.empty() || open_.back() != tag.name) {
      return scanner_.complain_of_close(tag);
    }
    open_.pop_back();
    return {};
  }

  Result<void> open(const XmlTag& tag) {
    if (open_.empty() && (seen_root_ || tag.name != "VTKFile")) {
      return scanner_.complain(tag.position, seen_root_ ? "something follows the end of the data"
                                                        : "this is no VTK XML file");
    }
    if (open_.size() >= kDeepestTags) {
      return scanner_.complain(
          tag.position, "the tags are nested more than " + std::to_string(kDeepestTags) + " deep");
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
    VtpPiece piece;
    piece.position = tag.position;
    piece.first_array = arrays.size();
    const auto count = [&](const char* key, std::size_t& value) {
      const std::string* const text = tag.find(key);
      if (text == nullptr) return true;
      const auto number = parse_integer(*text);
      if (!number || *number < 0) return false;
      value = static_cast<std::size_t>(*number);
      return true;
    };
    bool valid = count("NumberOfPoints", piece.points);
    for (std::size_t k = 0; k < kKinds; ++k) {
      valid = valid && count(kCounts[k], piece.count[k]);
    }
    if (!valid) return scanner_.complain(tag.position, "the piece has a count that is none");
    pieces.push_back(piece);
    return {};
  }

  Result<void> take_array(const XmlTag& tag) {
    VtpPiece& piece = pieces.back();
    const std::string_view group = open_.back();
    const std::string* const name = tag.find("Name");
    if (group == "CellData") {
      piece.tells_sections = piece.tells_sections || (name != nullptr && *name == kSectionOfLine);
      return {};
    }
    if (group == "Points") return declare(tag, "Points", VtpRole::points, kKinds);
    const auto known = std::find(kElementGroups.begin(), kElementGroups.end(), group);
    if (known == kElementGroups.end() || name == nullptr) return {};
    const auto kind = static_cast<ElementKind>(known - kElementGroups.begin());
    if (*name == "connectivity") return declare(tag, "connectivity", VtpRole::connectivity, kind);
    if (*name == "offsets") return declare(tag, "offsets", VtpRole::offsets, kind);
    return {};
  }

  Result<void> declare(const XmlTag& tag, std::string_view name, VtpRole role, ElementKind kind) {
    if (find(pieces.size() - 1, role, kind) != nullptr) {
      return scanner_.complain(tag.position,
                               in_quotes(open_.back()) + " has two arrays " + in_quotes(name));
    }
    Result<DataArray> declared = declare_array(tag, name, scanner_);
    if (!declared) return declared.error();
    if (tag.kind == XmlTag::Kind::open) declared->text = scanner_.take_text();
    arrays.push_back({role, kind, *declared});
    return {};
  }

  XmlScanner& scanner_;
  std::vector<std::string_view> open_;
  bool seen_root_ = false;
};

class VtpReader {
 public:
  explicit VtpReader(const Source& source) : scanner_(source.bytes, source.name), file_(scanner_) {}

  Result<void> scan(const std::vector<ElementKind>& kinds) {
    if (Result<void> scanned = file_.scan(); !scanned) return scanned;
    std::vector<const DataArray*> arrays;
    for (const VtpArray& array : file_.arrays) {
      const bool read =
          array.kind == kKinds || std::find(kinds.begin(), kinds.end(), array.kind) != kinds.end();
      if (read) arrays.push_back(&array.data);
    }
    if (Result<void> apart = check_apart(arrays); !apart) return apart;
    return check_unpacking(arrays, file_.source, kPolyDataUnpacked, scanner_);
  }

  [[nodiscard]] bool has(ElementKind kind) const {
    return std::any_of(file_.pieces.begin(), file_.pieces.end(),
                       [&](const VtpPiece& piece) { return piece.count[kind] > 0; });
  }
  [[nodiscard]] const std::vector<VtpPiece>& pieces() const { return file_.pieces; }

  Result<std::vector<Point3>> points_of(std::size_t p) const {
    const VtpPiece& piece = file_.pieces[p];
    std::vector<Point3> points;
    const DataArray* const array = file_.find(p, VtpRole::points);
    if (array == nullptr) {
      if (piece.points == 0) return points;
      return scanner_.complain(piece.position, "the piece has no Points");
    }
    const auto values = read_doubles(*array, file_.source, scanner_);
    if (!values) return values.error();
    if (array->components != 3 || values->size() % 3 != 0 || values->size() / 3 != piece.points) {
      return scanner_.complain(array->position, "Points has " + std::to_string(values->size()) +
                                                    " values where three each are due of " +
                                                    std::to_string(piece.points) + " points");
    }
    points.reserve(piece.points);
    for (std::size_t i = 0; i < values->size(); i += 3) {
      const Point3 q{(*values)[i], (*values)[i + 1], (*values)[i + 2]};
      if (!std::isfinite(q.x) || !std::isfinite(q.y) || !std::isfinite(q.z)) {
        return scanner_.complain(array->position,
                                 "point " + std::to_string(i / 3) + " is not finite");
      }
      points.push_back(q);
    }
    return points;
  }

  // Calls take(ids) for each element.
  template <class Take>
  Result<void> for_each_element(std::size_t p, ElementKind kind, Take&& take) const {
    const VtpPiece& piece = file_.pieces[p];
    if (piece.count[kind] == 0) return {};
    const DataArray* const connectivity = file_.find(p, VtpRole::connectivity, kind);
    const DataArray* const ends = file_.find(p, VtpRole::offsets, kind);
    if (connectivity == nullptr || ends == nullptr) {
      return scanner_.complain(piece.position, in_quotes(kElementGroups[kind]) +
                                                   " lacks the array 'connectivity' or 'offsets'");
    }
    const auto ids = read_integers(*connectivity, file_.source, scanner_);
    if (!ids) return ids.error();
    const auto offsets = read_integers(*ends, file_.source, scanner_);
    if (!offsets) return offsets.error();
    if (offsets->size() != piece.count[kind]) {
      return scanner_.complain(ends->position, "offsets has " + std::to_string(offsets->size()) +
                                                   " values where " +
                                                   std::to_string(piece.count[kind]) + " are due");
    }
    for (const std::int64_t id : *ids) {
      if (id >= 0 && static_cast<std::uint64_t>(id) < piece.points) continue;
      return scanner_.complain(connectivity->position, "connectivity refers to point " +
                                                           std::to_string(id) + " of " +
                                                           std::to_string(piece.points));
    }
    std::size_t from = 0;
    for (const std::int64_t offset : *offsets) {
      if (offset < 0 || static_cast<std::uint64_t>(offset) < from ||
          static_cast<std::uint64_t>(offset) > ids->size()) {
        return scanner_.complain(ends->position, "offsets do not increase within connectivity");
      }
      const auto to = static_cast<std::size_t>(offset);
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
  const ElementKind kind = reader.has(kLines) ? kLines : kPolys;
  Drawing drawing;
  drawing.structures.emplace_back();
  std::vector<DrawnLine>& lines = drawing.structures.front().lines;
  bool level = true;
  for (std::size_t p = 0; p < reader.pieces().size(); ++p) {
    const Result<std::vector<Point3>> points = reader.points_of(p);
    if (!points) return points.error();
    level = level && reader.pieces()[p].tells_sections;
    Result<void> taken = reader.for_each_element(p, kind, [&](const auto& ids) {
      if (ids.empty()) return;
      lines.push_back(line_of(ids, *points, kind == kPolys));
      for (const Point3& q : lines.back().points) {
        level = level && q.z == lines.back().points.front().z;
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
  for (const VtpPiece& piece : reader.pieces()) {
    if (kind == kLines) others += piece.count[kPolys];
    others += piece.count[kStrips];
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
  for (std::size_t p = 0; p < reader.pieces().size(); ++p) {
    const Result<std::vector<Point3>> points = reader.points_of(p);
    if (!points) return points.error();
    read.points.insert(read.points.end(), points->begin(), points->end());
  }
  return read;
}

Result<ReadTriangles> read_vtp_triangles(const Source& source, const ReadOptions& /*options*/) {
  VtpReader reader(source);
  if (Result<void> scanned = reader.scan({kPolys}); !scanned) return scanned.error();
  PolygonList polygons;
  std::size_t strips = 0;
  for (std::size_t p = 0; p < reader.pieces().size(); ++p) {
    const Result<std::vector<Point3>> points = reader.points_of(p);
    if (!points) return points.error();
    const std::size_t first = polygons.points();
    for (const Point3& q : *points) polygons.add_point(q);
    strips += reader.pieces()[p].count[kStrips];
    std::vector<std::uint32_t> corners;
    Result<void> taken = reader.for_each_element(p, kPolys, [&](const auto& ids) {
      corners.clear();
      for (const std::int64_t id : ids) {
        corners.push_back(static_cast<std::uint32_t>(first + static_cast<std::size_t>(id)));
      }
      polygons.add_polygon(corners, p);
    });
    if (!taken) return taken.error();
  }
  ReadTriangles read = polygons.take(source.name);
  if (strips > 0) {
    read.warnings.push_back({"left out: " + std::to_string(strips) + " strips", {}});
  }
  return read;
}

}  // namespace tetloft::internal::io
