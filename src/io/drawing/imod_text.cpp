// IMOD models as text: lines of a word and what it says. Those that matter here:
//
//   imod OBJECTS                    first
//   pixsize S · units nm · scale X Y Z      anywhere
//   object N CONTOURS MESHES        then its properties: name …, open, closed, scattered
//   contour N SURFACE POINTS        then lines x y z, with more behind them or not
//   contflags F                     of the contour before
//   mesh N VERTICES INDICES         then lines of numbers, which are passed over
#include "io/drawing/imod_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "io/drawing/text_lines.hpp"
#include "io/drawing/triples.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

bool is_comment_or_blank(std::string_view line) { return line.empty() || line.front() == '#'; }

class ImodTextReader {
 public:
  explicit ImodTextReader(const Source& source) : source_(source), warnings_(source.name) {}

  Result<Drawing> read() {
    drawing_.apart = true;
    drawing_.chosen_by = "--roi";
    drawing_.leaves_out_open = true;
    drawing_.unit = "pixel";
    std::string_view rest = without_mark(source_.bytes);
    for (line_ = 1; !rest.empty(); ++line_) {
      const std::string_view line = without_padding(cut_line(rest));
      if (is_comment_or_blank(line)) continue;
      if (Result<void> taken = take(line); !taken) return taken.error();
    }
    if (awaited_ > 0) return missing_points("the file ends");
    if (Result<void> done = finish(); !done) return done.error();
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  struct Kind {
    bool open = false;
    bool scattered = false;
    std::vector<std::size_t> open_contours;
  };

  Error wrong(const std::string& message) const { return row_error(source_.name, line_, message); }
  Error missing_points(const std::string& why) const {
    return wrong(why + " where " + std::to_string(awaited_) + " more points of contour " +
                 std::to_string(drawing_.structures.back().lines.size()) + " of object " +
                 std::to_string(drawing_.structures.size()) + " have to be");
  }

  Result<void> take(std::string_view line) {
    split(line);
    const std::string_view word = words_[0];
    const bool number = parse_number(word).ok();
    if (awaited_ > 0) return number ? take_point() : missing_points("there is " + in_quotes(word));
    if (number) return in_mesh_ ? Result<void>() : wrong("numbers that belong to nothing");
    if (word == "object") return take_object();
    if (word == "contour") return take_contour();
    in_mesh_ = word == "mesh";
    if (drawing_.structures.empty()) return take_property_of_model(word);
    if (word == "name") {
      drawing_.structures.back().name = without_padding(line.substr(word.size()));
    }
    if (word == "open") kinds_.back().open = true;
    if (word == "closed") kinds_.back().open = false;
    if (word == "scattered") kinds_.back().scattered = true;
    if (word == "contflags") return take_flags();
    return take_property_of_model(word);
  }

  // Of the words only the first few matter.
  void split(std::string_view line) {
    TextCursor cursor(line);
    words_ = {};
    for (std::string_view& word : words_) {
      cursor.skip_blanks();
      word = cursor.token();
    }
  }

  Result<std::int64_t> integer(std::string_view word, const std::string& what) const {
    const auto value = parse_integer(word);
    if (!value || *value < 0) return wrong(in_quotes(word) + " is no " + what);
    return *value;
  }

  Result<void> take_property_of_model(std::string_view word) {
    if (word == "units") drawing_.unit = words_[1];
    if (word != "pixsize" && word != "scale") return {};
    const std::string_view token = words_[word == "scale" ? 3 : 1];
    const ParsedNumber number = parse_number(token);
    if (!number.ok()) return wrong(complaint(token, number.status));
    if (!(number.value > 0)) {
      warnings_.add("a " + std::string(word) + " that is not above 0: 1 is taken", line_);
      return {};
    }
    (word == "scale" ? z_scale_ : pixel_) = number.value;
    return {};
  }

  Result<void> take_object() {
    const auto number = static_cast<std::int64_t>(drawing_.structures.size()) + 1;
    drawing_.structures.push_back({number, {}, {}});
    kinds_.emplace_back();
    in_mesh_ = false;
    return {};
  }

  Result<void> take_contour() {
    if (drawing_.structures.empty()) return wrong("a contour before any object");
    const Result<std::int64_t> points = integer(words_[3], "number of points");
    if (!points) return points.error();
    awaited_ = *points;
    in_mesh_ = false;
    drawing_.structures.back().lines.emplace_back();
    drawing_.structures.back().lines.back().line = line_;
    return {};
  }

  Result<void> take_point() {
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const ParsedNumber number = parse_number(words_[i]);
      if (!number.ok()) return wrong(complaint(words_[i], number.status));
      xyz[i] = number.value;
    }
    drawing_.structures.back().lines.back().points.push_back({xyz[0], xyz[1], xyz[2]});
    --awaited_;
    return {};
  }

  Result<void> take_flags() {
    const Result<std::int64_t> flags = integer(words_[1], "flags of a contour");
    if (!flags) return flags.error();
    const std::size_t contours = drawing_.structures.back().lines.size();
    if (contours > 0 && (*flags & kOpenContour) != 0) {
      kinds_.back().open_contours.push_back(contours - 1);
    }
    return {};
  }

  // Scales and kinds, of which the words may stand anywhere.
  Result<void> finish() {
    for (std::size_t s = 0; s < kinds_.size(); ++s) {
      const Kind& kind = kinds_[s];
      std::vector<DrawnLine>& lines = drawing_.structures[s].lines;
      for (DrawnLine& line : lines) {
        line.kind = kind.scattered ? LineKind::points
                    : kind.open    ? LineKind::open
                                   : LineKind::closed;
        for (Point3& p : line.points) {
          p = {pixel_ * p.x, pixel_ * p.y, pixel_ * z_scale_ * p.z};
          if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
          return row_error(source_.name, line.line,
                           "a point that is not finite in the unit of the model");
        }
      }
      if (kind.scattered) continue;
      for (const std::size_t c : kind.open_contours) lines[c].kind = LineKind::open;
    }
    return {};
  }

  static constexpr std::int64_t kOpenContour = 1 << 3;

  const Source& source_;
  WarningList warnings_;
  Drawing drawing_;
  std::size_t line_ = 1;
  std::array<std::string_view, 4> words_;
  std::int64_t awaited_ = 0;  // points of the contour that is read
  bool in_mesh_ = false;
  double pixel_ = 1;
  double z_scale_ = 1;
  std::vector<Kind> kinds_;  // of objects
};

}  // namespace

bool begins_as_imod_text(std::string_view bytes) {
  constexpr std::size_t kMostComments = 100;
  bytes = without_mark(bytes);
  for (std::size_t i = 0; i < kMostComments && !bytes.empty(); ++i) {
    const std::string_view line = without_padding(cut_line(bytes));
    if (is_comment_or_blank(line)) continue;
    TextCursor cursor(line);
    if (cursor.token() != "imod") return false;
    cursor.skip_blanks();
    return parse_integer(cursor.token()).has_value();
  }
  return false;
}

Result<Drawing> read_imod_text(const Source& source) { return ImodTextReader(source).read(); }

}  // namespace tetloft::internal::io
