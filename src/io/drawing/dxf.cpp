// DXF (AutoCAD's drawing interchange, as text): polylines with their elevations, lines and
// circles, of the section ENTITIES. A file is pairs of lines: a group code, and a value.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/cursor.hpp"
#include "io/drawing/dxf_arc.hpp"
#include "io/drawing/ellipse.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::string_view kBinary = "AutoCAD Binary DXF";

struct DxfGroup {
  std::int64_t code = 0;
  std::string_view value;
  std::size_t line = 0;  // of the value
};

class DxfGroups {
 public:
  DxfGroups(std::string_view text, const std::string& name) : text_(text), name_(name) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
  }

  /// Nothing at the end.
  Result<std::optional<DxfGroup>> next() {
    using Read = std::optional<DxfGroup>;
    std::string_view code_text;
    do {
      if (at_ >= text_.size()) return Read();
      code_text = trimmed(take_line());
    } while (code_text.empty() && at_ >= text_.size());
    DxfGroup group;
    const auto code = parse_integer(code_text);
    if (!code) return complain(in_quotes(code_text) + " is no group code", line_);
    if (at_ >= text_.size()) return complain("a group code without a value ends the file", line_);
    group.code = *code;
    group.value = trimmed(take_line());
    group.line = line_;
    return Read(group);
  }

  [[nodiscard]] Error complain(const std::string& message, std::size_t line) const {
    Error error{ErrorCode::invalid_input, message, {}};
    error.where.file = name_;
    error.where.line = line;
    return error;
  }

 private:
  // Ends with LF, CRLF or CR.
  std::string_view take_line() {
    ++line_;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end;
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n' && (at_ == end || text_[at_ - 1] == '\r')) ++at_;
    return line;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
};

// What is read of an entity. Coordinates by the last digit of their groups: 10, 20, 30 are x, y, z
// of place 0; 11, 21, 31 of place 1.
struct DxfEntity {
  std::string_view type;
  std::size_t line = 0;
  std::int64_t flags = 0;
  std::array<Point3, 2> place{};
  double elevation = 0;  // 38
  double bulge = 0;      // 42
  double radius = 0;     // 40
  Point3 normal{0, 0, 1};
};

constexpr std::int64_t kClosed = 1;
constexpr std::int64_t kInSpace = 8;
constexpr std::int64_t kMesh = 16 | 64;
constexpr std::int64_t kSplineControl = 16;  // of a vertex

// A polyline that is read: its vertices with bulges.
struct DxfPolyline {
  DxfEntity head;
  std::vector<Point3> points;
  std::vector<double> bulges;
  bool old_form = false;  // POLYLINE, with VERTEX entities that follow
};

std::string unit_of(std::int64_t code) {
  switch (code) {
    case 1: return "in";
    case 2: return "ft";
    case 4: return "mm";
    case 5: return "cm";
    case 6: return "m";
    case 7: return "km";
    case 13: return "um";
    default: return {};
  }
}

class DxfReader {
 public:
  DxfReader(std::string_view bytes, const std::string& name)
      : groups_(bytes, name), budget_(bytes.size() / 2 + 4096) {}

  Result<Drawing> read() {
    for (;;) {
      const Result<std::optional<DxfGroup>> group = groups_.next();
      if (!group) return group.error();
      if (!group->has_value()) break;
      last_line_ = (*group)->line;
      Result<void> taken = take(**group);
      if (!taken) return taken.error();
      if (ended_) break;
    }
    if (section_ != Section::none) {
      return groups_.complain("the file ends inside of a section: its end is missing", last_line_);
    }
    if (!seen_entities_) return groups_.complain("the file has no section ENTITIES", last_line_);
    tell();
    drawing_.exact_heights = !varying_;
    drawing_.structures.push_back({0, {}, std::move(lines_)});
    return std::move(drawing_);
  }

 private:
  enum class Section : std::uint8_t { none, begun, header, entities, other };

  Result<void> take(const DxfGroup& group) {
    if (group.code == 999) return {};
    if (group.code == 0) return take_start(group);
    if (section_ == Section::begun && group.code == 2) {
      section_ = group.value == "HEADER"     ? Section::header
                 : group.value == "ENTITIES" ? Section::entities
                                             : Section::other;
      seen_entities_ = seen_entities_ || section_ == Section::entities;
      return {};
    }
    if (section_ == Section::header) {
      if (group.code == 9) variable_ = group.value;
      if (group.code == 70 && variable_ == "$INSUNITS") {
        drawing_.unit = unit_of(parse_integer(group.value).value_or(0));
      }
      return {};
    }
    return section_ == Section::entities ? take_value(group) : Result<void>();
  }

  // An entity, or the begin or end of a section.
  Result<void> take_start(const DxfGroup& group) {
    if (group.value == "EOF" && section_ == Section::none) {
      ended_ = true;
      return {};
    }
    if (group.value == "SECTION") {
      if (section_ != Section::none) {
        return groups_.complain("a section begins inside of another", group.line);
      }
      section_ = Section::begun;
      return {};
    }
    if (section_ == Section::entities) {
      if (Result<void> finished = finish_entity(); !finished) return finished;
      entity_ = {};
      entity_.type = group.value;
      entity_.line = group.line;
      if (group.value == "LWPOLYLINE" || group.value == "POLYLINE") polyline_ = DxfPolyline();
    }
    if (group.value == "ENDSEC") {
      if (polyline_) return groups_.complain("a POLYLINE has no SEQEND", group.line);
      section_ = Section::none;
    }
    return {};
  }

  Result<void> take_value(const DxfGroup& group) {
    const auto code = group.code;
    if (code == 70) {
      entity_.flags = parse_integer(group.value).value_or(0);
      return {};
    }
    double* const target = target_of(code);
    if (target == nullptr) return {};
    const ParsedNumber number = parse_number(group.value);
    if (!number.ok()) return groups_.complain(complaint(group.value, number.status), group.line);
    // A vertex of an LWPOLYLINE begins with its x.
    if (entity_.type == "LWPOLYLINE" && code == 10) {
      polyline_->points.push_back({});
      polyline_->bulges.push_back(0);
    }
    *target = number.value;
    if (entity_.type != "LWPOLYLINE" || polyline_->points.empty()) return {};
    if (code == 10) polyline_->points.back().x = number.value;
    if (code == 20) polyline_->points.back().y = number.value;
    if (code == 42) polyline_->bulges.back() = number.value;
    return {};
  }

  double* target_of(std::int64_t code) {
    switch (code) {
      case 10: return &entity_.place[0].x;
      case 20: return &entity_.place[0].y;
      case 30: return &entity_.place[0].z;
      case 11: return &entity_.place[1].x;
      case 21: return &entity_.place[1].y;
      case 31: return &entity_.place[1].z;
      case 38: return &entity_.elevation;
      case 40: return &entity_.radius;
      case 42: return &entity_.bulge;
      case 210: return &entity_.normal.x;
      case 220: return &entity_.normal.y;
      case 230: return &entity_.normal.z;
      default: return nullptr;
    }
  }

  Result<void> finish_entity() {
    const std::string_view type = entity_.type;
    if (type.empty()) return {};
    const bool within = polyline_ && polyline_->old_form;
    if (within && type == "VERTEX") return take_vertex();
    if (within && type == "SEQEND") return finish_polyline();
    if (within) {
      return groups_.complain("a POLYLINE has no SEQEND before " + in_quotes(type), entity_.line);
    }
    if (type == "POLYLINE") {
      polyline_->head = entity_;
      polyline_->old_form = true;
      return {};
    }
    if (type == "LWPOLYLINE") {
      polyline_->head = entity_;
      for (Point3& p : polyline_->points) p.z = entity_.elevation;
      return finish_polyline();
    }
    if (type == "LINE") return add_line({entity_.place[0], entity_.place[1]}, false, entity_);
    if (type == "CIRCLE") return add_circle();
    if (type != "ENDSEC") ++left_out_[std::string(type)];
    return {};
  }

  Result<void> take_vertex() {
    // Of a curve through points, these are what it was made from.
    if ((entity_.flags & kSplineControl) != 0) return {};
    Point3 p = entity_.place[0];
    if ((polyline_->head.flags & kInSpace) == 0) p.z = polyline_->head.place[0].z;
    polyline_->points.push_back(p);
    polyline_->bulges.push_back(entity_.bulge);
    return {};
  }

  Result<void> finish_polyline() {
    const DxfPolyline polyline = *std::exchange(polyline_, std::nullopt);
    if (polyline.old_form && (polyline.head.flags & kMesh) != 0) {
      ++left_out_["POLYLINE of a mesh"];
      return {};
    }
    const bool closed = (polyline.head.flags & kClosed) != 0;
    const std::vector<Point3>& in = polyline.points;
    std::vector<Point3> points;
    points.reserve(in.size());
    for (std::size_t i = 0; i < in.size(); ++i) {
      points.push_back(in[i]);
      const double bulge = polyline.bulges[i];
      if (bulge == 0 || (i + 1 == in.size() && !closed)) continue;
      ++arcs_;
      const std::size_t before = points.size();
      append_arc(in[i], in[(i + 1) % in.size()], bulge, points);
      if (points.size() - before > budget_) {
        return groups_.complain("the file has more arcs than can be turned into lines",
                                polyline.head.line);
      }
      budget_ -= points.size() - before;
    }
    return add_line(std::move(points), closed, polyline.head);
  }

  Result<void> add_circle() {
    if (!(entity_.radius > 0) || budget_ < kEllipsePoints) {
      ++left_out_["CIRCLE"];
      return {};
    }
    budget_ -= kEllipsePoints;
    ++arcs_;
    const Point3& centre = entity_.place[0];
    std::vector<Point3> points;
    for (const Point2& p : ellipse_points({centre.x, centre.y}, entity_.radius, entity_.radius))
      points.push_back({p.x, p.y, centre.z});
    return add_line(std::move(points), true, entity_);
  }

  // Coordinates are those of the entity's own plane, but for lines and polylines in space.
  Result<void> add_line(std::vector<Point3> points, bool closed, const DxfEntity& head) {
    const bool in_space =
        head.type == "LINE" || (head.type == "POLYLINE" && (head.flags & kInSpace) != 0);
    if (!in_space) {
      const bool flat = head.normal.x == 0 && head.normal.y == 0 && head.normal.z != 0;
      if (!flat) {
        return groups_.complain(
            "a " + std::string(head.type) + " whose plane is not horizontal (groups 210 to 230)",
            head.line);
      }
      // Seen from below: the axes of the plane are −x, y, −z.
      if (head.normal.z < 0) {
        for (Point3& p : points) p = {-p.x, p.y, -p.z};
      }
    }
    if (points.empty()) {
      ++left_out_[std::string(head.type) + " without vertices"];
      return {};
    }
    DrawnLine line;
    line.line = head.line;
    const bool returns = points.size() > 2 && points.front() == points.back();
    line.kind = closed || returns ? LineKind::closed : LineKind::open;
    for (const Point3& p : points) {
      varying_ = varying_ || p.z != points.front().z;
      if (std::isfinite(p.x) && std::isfinite(p.y)) continue;
      return groups_.complain("an arc is too large", head.line);
    }
    line.points = std::move(points);
    lines_.push_back(std::move(line));
    return {};
  }

  void tell() {
    for (const auto& [type, count] : left_out_) {
      const bool block = type == "INSERT";
      drawing_.warnings.push_back(
          {"left out: " + std::to_string(count) + " of type " + in_quotes(type) +
               (block ? " (explode the blocks to have what is in them)" : ""),
           {}});
    }
    if (arcs_ == 0) return;
    drawing_.warnings.push_back({std::to_string(arcs_) + (arcs_ == 1 ? " arc is" : " arcs are") +
                                     " made of line segments, off by 1/200 of the radius or less",
                                 {}});
  }

  DxfGroups groups_;
  Section section_ = Section::none;
  bool seen_entities_ = false;
  bool ended_ = false;
  std::size_t last_line_ = 0;
  std::string_view variable_;  // of the header
  DxfEntity entity_;           // that is read
  std::optional<DxfPolyline> polyline_;
  std::vector<DrawnLine> lines_;
  Drawing drawing_;
  std::map<std::string, std::size_t> left_out_;
  std::size_t arcs_ = 0;
  std::size_t budget_;  // points of arcs
  bool varying_ = false;
};

// "0", "SECTION", perhaps comments before; or the mark of the binary form.
bool is_dxf(std::string_view bytes) {
  if (bytes.substr(0, kBinary.size()) == kBinary) return true;
  const std::string name;
  DxfGroups groups(bytes.substr(0, 4096), name);
  for (;;) {
    const Result<std::optional<DxfGroup>> group = groups.next();
    if (!group || !group->has_value()) return false;
    if ((*group)->code == 999) continue;
    return (*group)->code == 0 && (*group)->value == "SECTION";
  }
}

Result<Drawing> read_dxf(const Source& source, const ReadOptions& /*options*/) {
  if (source.bytes.substr(0, kBinary.size()) == kBinary) {
    Error error{ErrorCode::invalid_input,
                "this is DXF in its binary form, which is not read: save it as text (ASCII DXF)",
                {}};
    error.where.file = source.name;
    return error;
  }
  return DxfReader(source.bytes, source.name).read();
}

}  // namespace

extern constinit const Format dxf_format{.name = "dxf",
                                         .summary = "DXF polylines",
                                         .extensions = {".dxf"},
                                         .recognise = is_dxf,
                                         .read_drawing = read_dxf};

}  // namespace tetloft::internal::io
