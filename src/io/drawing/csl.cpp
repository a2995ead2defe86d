// CSL, labelled cross sections in any planes (Bermano, Vaxman, Gotsman, "Online reconstruction of
// 3D objects from arbitrary cross-sections", 2011, and programs since):
//
//   CSLC
//   PLANES LABELS
//   ID VERTICES COMPONENTS A B C D      of each plane, A x + B y + C z + D = 0
//   x y z                               of each vertex
//   COUNT LABEL i j k …                 of each component, vertices from 0; COUNThPARENT of a hole
//
// Some writers mean A x + B y + C z = D: the vertices tell.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "io/drawing/csl_write.hpp"
#include "io/drawing/text_lines.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

bool begins_as_csl(std::string_view bytes) {
  TextCursor cursor(bytes.substr(0, 64));
  cursor.skip_white();
  return cursor.token() == "CSLC";
}

struct CslPlane {
  std::int64_t id = 0;
  std::size_t line = 0;
  std::size_t vertices = 0;
  std::size_t components = 0;
  Point3 normal;  // of unit length
  double offset = 0;
};

// How far vertices lie from their planes if the fourth number is added, or subtracted.
struct CslDistance {
  double farthest = 0;
  std::size_t plane = 0;
  std::size_t vertex = 0;
};

class CslReader {
 public:
  explicit CslReader(const Source& source)
      : source_(source), lines_(source.bytes), warnings_(source.name) {}

  Result<Drawing> read() {
    drawing_.chosen_by = "--label";
    drawing_.labelled = true;
    drawing_.structures.emplace_back();
    if (!lines_.next() || lines_.words() != Words{"CSLC"}) return wrong("expected \"CSLC\"");
    if (Result<void> done = read_header(); !done) return done.error();
    for (std::size_t p = 0; p < told_planes_; ++p) {
      if (Result<void> done = read_plane(); !done) return done.error();
    }
    if (lines_.next()) {
      return wrong("expected the end of the file behind its " + std::to_string(told_planes_) +
                   (told_planes_ == 1 ? " plane" : " planes"));
    }
    if (Result<void> done = check_distances(); !done) return done.error();
    find_oblique();
    drawing_.planes = planes_.size();
    drawing_.exact_heights = level_;
    warn();
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  using Words = std::vector<std::string_view>;

  Error wrong(const std::string& message) const {
    return row_error(source_.name, lines_.line(), message);
  }
  Error wrong_form(const std::string& form) const {
    return row_form_error(source_.name, lines_.line(), form, lines_.words().size());
  }

  // The next line, which has to be there.
  Result<void> expect(const std::string& what) {
    if (lines_.next()) return {};
    return wrong("the file ends where " + what + " has to be");
  }

  Result<std::size_t> count(std::string_view word, const std::string& what) const {
    const auto value = parse_integer(word);
    if (!value || *value < 0) return wrong(in_quotes(word) + " is no number of " + what);
    return static_cast<std::size_t>(*value);
  }

  Result<double> number(std::string_view word) const {
    const ParsedNumber number = parse_number(word);
    if (!number.ok()) return wrong(complaint(word, number.status));
    return number.value;
  }

  Result<void> read_header() {
    if (Result<void> there = expect("\"PLANES LABELS\""); !there) return there;
    if (lines_.words().size() != 2) return wrong_form("PLANES LABELS");
    const Result<std::size_t> planes = count(lines_.words()[0], "planes");
    if (!planes) return planes.error();
    const Result<std::size_t> labels = count(lines_.words()[1], "labels");
    if (!labels) return labels.error();
    told_planes_ = *planes;
    told_labels_ = *labels;
    return {};
  }

  Result<void> read_plane() {
    const std::string form = "ID VERTICES COMPONENTS A B C D";
    if (Result<void> there = expect("plane " + std::to_string(planes_.size() + 1) + " of " +
                                    std::to_string(told_planes_));
        !there) {
      return there;
    }
    if (lines_.words().size() != 7) return wrong_form(form);
    CslPlane plane;
    plane.line = lines_.line();
    const auto id = parse_integer(lines_.words()[0]);
    if (!id) return wrong(in_quotes(lines_.words()[0]) + " is no number of a plane");
    plane.id = *id;
    const Result<std::size_t> vertices = count(lines_.words()[1], "vertices");
    if (!vertices) return vertices.error();
    const Result<std::size_t> components = count(lines_.words()[2], "components");
    if (!components) return components.error();
    plane.vertices = *vertices;
    plane.components = *components;
    if (Result<void> done = read_equation(plane); !done) return done;
    planes_.push_back(plane);
    if (Result<void> done = read_vertices(); !done) return done;
    return read_components();
  }

  Result<void> read_equation(CslPlane& plane) const {
    std::array<double, 4> equation{};
    double largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Result<double> value = number(lines_.words()[3 + i]);
      if (!value) return value.error();
      equation[i] = *value;
      if (i < 3) largest = std::max(largest, std::abs(*value));
    }
    if (largest == 0) return wrong("the normal of plane " + std::to_string(plane.id) + " is zero");
    // Divided before it is squared, which might be beyond the largest double.
    const Point3 n{equation[0] / largest, equation[1] / largest, equation[2] / largest};
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    plane.normal = {n.x / length, n.y / length, n.z / length};
    plane.offset = equation[3] / largest / length;
    return {};
  }

  Result<void> read_vertices() {
    const CslPlane& plane = planes_.back();
    vertices_.clear();
    for (std::size_t v = 0; v < plane.vertices; ++v) {
      if (Result<void> there =
              expect("vertex " + std::to_string(v) + " of plane " + std::to_string(plane.id));
          !there) {
        return there;
      }
      if (lines_.words().size() != 3) return wrong_form("x y z");
      std::array<double, 3> xyz{};
      for (std::size_t i = 0; i < 3; ++i) {
        const Result<double> value = number(lines_.words()[i]);
        if (!value) return value.error();
        xyz[i] = *value;
      }
      take_vertex({xyz[0], xyz[1], xyz[2]});
    }
    return {};
  }

  void take_vertex(const Point3& p) {
    const CslPlane& plane = planes_.back();
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = i == 0 ? p.x : i == 1 ? p.y : p.z;
      low_[i] = std::min(low_[i], value);
      high_[i] = std::max(high_[i], value);
    }
    const double along = plane.normal.x * p.x + plane.normal.y * p.y + plane.normal.z * p.z;
    const std::array<double, 2> distance{std::abs(along + plane.offset),
                                         std::abs(along - plane.offset)};
    for (std::size_t sign = 0; sign < 2; ++sign) {
      if (distance[sign] > distance_[sign].farthest) {
        distance_[sign] = {distance[sign], planes_.size() - 1, vertices_.size()};
      }
    }
    vertices_.push_back(p);
  }

  Result<void> read_components() {
    const CslPlane& plane = planes_.back();
    std::vector<DrawnLine>& lines = drawing_.structures[0].lines;
    const std::size_t first = lines.size();
    std::vector<std::optional<std::size_t>> parents;
    used_in_.assign(vertices_.size(), 0);
    for (std::size_t c = 0; c < plane.components; ++c) {
      if (Result<void> there =
              expect("component " + std::to_string(c) + " of plane " + std::to_string(plane.id));
          !there) {
        return there;
      }
      Result<std::optional<std::size_t>> parent = read_component(c);
      if (!parent) return parent.error();
      parents.push_back(*parent);
    }
    // A hole is of the label around it, whatever stands in its own line.
    for (std::size_t c = 0; c < parents.size(); ++c) {
      if (parents[c]) lines[first + c].label = lines[first + *parents[c]].label;
    }
    return {};
  }

  // Returns the parent, of a hole that names one.
  Result<std::optional<std::size_t>> read_component(std::size_t c) {
    const Words& words = lines_.words();
    if (words.size() < 3) return wrong_form("COUNT LABEL i j k …");
    // The h of a hole stands behind the count, with writers of old behind the label.
    Words numbers;
    std::optional<std::size_t> parent;
    for (const std::string_view word : {words[0], words[1]}) {
      const std::size_t h = word.find('h');
      numbers.push_back(word.substr(0, h));
      if (h == std::string_view::npos || h + 1 == word.size()) continue;
      const auto named = parse_integer(word.substr(h + 1));
      const bool in_range =
          named && *named >= -1 && *named < static_cast<std::int64_t>(planes_.back().components);
      if (!in_range || *named == static_cast<std::int64_t>(c)) {
        return wrong(in_quotes(word) +
                     ": a hole's parent is another component of its plane, "
                     "counted from 0");
      }
      if (*named >= 0) parent = static_cast<std::size_t>(*named);
    }
    const Result<std::size_t> told = count(numbers[0], "vertices");
    if (!told) return told.error();
    const auto label = parse_integer(numbers[1]);
    if (!label || *label < 0 || *label > std::numeric_limits<std::uint32_t>::max()) {
      return wrong(in_quotes(words[1]) + " is no label: an integer from 0 to 4294967295");
    }
    if (*told != words.size() - 2) {
      return wrong("the component has " + std::to_string(words.size() - 2) + " vertices, not " +
                   std::to_string(*told) + " as it tells");
    }
    if (static_cast<std::size_t>(*label) >= told_labels_ && odd_labels_++ == 0) {
      first_odd_label_ = lines_.line();
    }
    DrawnLine line;
    line.label = *label;
    line.line = lines_.line();
    if (Result<void> taken = take_indices(c, line); !taken) return taken.error();
    drawing_.structures[0].lines.push_back(std::move(line));
    return parent;
  }

  // The first index may be repeated at the end.
  Result<void> take_indices(std::size_t c, DrawnLine& line) {
    const Words& words = lines_.words();
    line.points.reserve(words.size() - 2);
    for (std::size_t i = 2; i < words.size(); ++i) {
      const auto index = parse_integer(words[i]);
      if (!index || *index < 0 || *index >= static_cast<std::int64_t>(vertices_.size())) {
        return wrong(in_quotes(words[i]) + " is no vertex of plane " +
                     std::to_string(planes_.back().id) + ", which has " +
                     std::to_string(vertices_.size()) + ", counted from 0");
      }
      const auto v = static_cast<std::size_t>(*index);
      const bool closes = i + 1 == words.size() && words.size() > 3 && words[i] == words[2];
      if (used_in_[v] == c + 1 && !closes) {
        return wrong("the component has vertex " + std::to_string(v) + " twice");
      }
      used_in_[v] = c + 1;
      line.points.push_back(vertices_[v]);
      level_ = level_ && line.points.back().z == line.points.front().z;
    }
    return {};
  }

  // Chooses the sign of D, and refuses vertices that are far from their planes.
  Result<void> check_distances() {
    subtracts_ = distance_[1].farthest < distance_[0].farthest;
    const CslDistance& off = distance_[subtracts_ ? 1 : 0];
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, high_[i] - low_[i]);
    if (planes_.empty() || !(off.farthest > kFar * extent)) return {};
    const CslPlane& plane = planes_[off.plane];
    std::string message =
        "vertex " + std::to_string(off.vertex) + " of plane " + std::to_string(plane.id) + " is ";
    append_number(message, off.farthest);
    return row_error(source_.name, plane.line,
                     message + " away from it: the equations and the vertices do not agree");
  }

  // The plane that is farthest from parallel to the first one.
  void find_oblique() {
    double farthest = kParallel;
    std::size_t other = 0;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      const double sine = sine_between(planes_[0].normal, planes_[p].normal);
      if (!(sine > farthest)) continue;
      farthest = sine;
      other = p;
    }
    if (other == 0) return;
    constexpr double kDegrees = 57.29577951308232;
    std::string message = "planes " + std::to_string(planes_[0].id) + " and " +
                          std::to_string(planes_[other].id) + " are not parallel, but at ";
    append_number(message, std::round(std::asin(std::min(1.0, farthest)) * kDegrees * 10) / 10);
    drawing_.not_parallel = message + " degrees (line " + std::to_string(planes_[other].line) + ')';
  }

  static double sine_between(const Point3& a, const Point3& b) {
    const Point3 c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
  }

  void warn() {
    if (subtracts_) {
      warnings_.add(
          "the vertices are where A x + B y + C z = D, not where the sum with D is zero, "
          "as the format has it");
    }
    std::size_t empty = 0;
    for (const CslPlane& plane : planes_) empty += plane.components == 0 ? 1 : 0;
    if (empty > 0) {
      warnings_.add(std::to_string(empty) + (empty == 1 ? " plane" : " planes") +
                    " without components left out");
    }
    if (odd_labels_ > 0) {
      warnings_.add(std::to_string(odd_labels_) +
                        " components have labels that are not below the number of labels, " +
                        std::to_string(told_labels_) + ", the first here",
                    first_odd_label_);
    }
  }

  // Files are written with ten digits or with two; a hundredth of all is no rounding.
  static constexpr double kFar = 0.01;
  // Normals that are nearer to parallel are judged by their contours.
  static constexpr double kParallel = 0.01;

  const Source& source_;
  TextLines lines_;
  WarningList warnings_;
  Drawing drawing_;
  std::size_t told_planes_ = 0;
  std::size_t told_labels_ = 0;
  std::vector<CslPlane> planes_;
  std::vector<Point3> vertices_;         // of the plane that is read
  std::vector<std::size_t> used_in_;     // of each, the last component that has it, from 1
  std::array<CslDistance, 2> distance_;  // with D added, and subtracted
  bool subtracts_ = false;
  bool level_ = true;  // no component has vertices of different z
  std::array<double, 3> low_{kInfinity, kInfinity, kInfinity};
  std::array<double, 3> high_{-kInfinity, -kInfinity, -kInfinity};
  std::size_t odd_labels_ = 0;
  std::size_t first_odd_label_ = 0;

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
};

Result<Drawing> read_csl(const Source& source, const ReadOptions& /*options*/) {
  return CslReader(source).read();
}

}  // namespace

extern constinit const Format csl_format{
    .name = "csl",
    .summary = "labelled contours in parallel planes of any direction (CSLC)",
    .extensions = {".csl"},
    .recognise = begins_as_csl,
    .read_drawing = read_csl,
    .write_stack = write_csl};

}  // namespace tetloft::internal::io
