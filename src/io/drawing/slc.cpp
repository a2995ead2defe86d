// SRL .slc, slice contours of the Surface Reconstruction Library (Hinds and others, 2006):
//
//   slice Z
//   contour closed          (or open)
//   x y                     of each vertex
//   adjacent
//   i j … -1                contours of the next slice that hang together with it, from 0
//
// Where no contour of a file has any, adjacency is what the program is to find out, as it is there.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/drawing/text_lines.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/rows.hpp"
#include "io/warning_list.hpp"

namespace tetloft::internal::io {

namespace {

bool begins_as_slc(std::string_view bytes) {
  TextLines lines(bytes.substr(0, 4096));
  if (!lines.next() || lines.words().size() != 2 || lines.words()[0] != "slice") return false;
  return parse_number(lines.words()[1]).ok() && lines.next() && lines.words()[0] == "contour";
}

class SlcReader {
 public:
  explicit SlcReader(const Source& source)
      : source_(source), lines_(source.bytes), warnings_(source.name) {}

  Result<Drawing> read() {
    drawing_.structures.emplace_back();
    if (!lines_.next()) return wrong("expected \"slice Z\"");
    while (!ended_) {
      if (Result<void> done = read_slice(); !done) return done.error();
    }
    first_of_slice_.push_back(drawn().size());
    resolve();
    drawing_.planes = first_of_slice_.size() - 1;
    drawing_.warnings = warnings_.take();
    return std::move(drawing_);
  }

 private:
  // As it stands in the file: an index into the next slice.
  struct Adjacent {
    std::size_t slice = 0;
    std::size_t line = 0;  ///< drawn
    std::int64_t index = 0;
    std::size_t text_line = 0;
  };

  [[nodiscard]] std::vector<DrawnLine>& drawn() { return drawing_.structures[0].lines; }

  Error wrong(const std::string& message) const {
    return row_error(source_.name, lines_.line(), message);
  }
  [[nodiscard]] bool at(std::string_view keyword) const {
    return !ended_ && lines_.words()[0] == keyword;
  }
  void advance() { ended_ = !lines_.next(); }

  Result<double> number(std::string_view word) const {
    const ParsedNumber number = parse_number(word);
    if (!number.ok()) return wrong(complaint(word, number.status));
    return number.value;
  }

  Result<void> read_slice() {
    if (!at("slice") || lines_.words().size() != 2) {
      return wrong("expected \"slice Z\"" +
                   std::string(first_of_slice_.empty() ? "" : " or \"contour open|closed\""));
    }
    const Result<double> z = number(lines_.words()[1]);
    if (!z) return z.error();
    first_of_slice_.push_back(drawn().size());
    advance();
    while (at("contour")) {
      if (Result<void> done = read_contour(*z); !done) return done;
    }
    return {};
  }

  Result<void> read_contour(double z) {
    const bool told = lines_.words().size() == 2;
    const bool closed = told && lines_.words()[1] == "closed";
    if (!closed && !(told && lines_.words()[1] == "open")) {
      return wrong("expected \"contour closed\" or \"contour open\"");
    }
    drawn().emplace_back();
    drawn().back().kind = closed ? LineKind::closed : LineKind::open;
    drawn().back().line = lines_.line();
    for (advance(); !ended_ && !at("adjacent"); advance()) {
      if (lines_.words().size() != 2) {
        return row_form_error(source_.name, lines_.line(), "x y", lines_.words().size());
      }
      const Result<double> x = number(lines_.words()[0]);
      if (!x) return x.error();
      const Result<double> y = number(lines_.words()[1]);
      if (!y) return y.error();
      drawn().back().points.push_back({*x, *y, z});
    }
    if (ended_) return wrong("the file ends within a contour, before its \"adjacent\"");
    return read_adjacent();
  }

  // Up to -1, on the line of the word or those behind it.
  Result<void> read_adjacent() {
    std::size_t next = 1;
    while (true) {
      for (; next < lines_.words().size(); ++next) {
        const auto index = parse_integer(lines_.words()[next]);
        if (!index || *index < -1) {
          return wrong(in_quotes(lines_.words()[next]) +
                       " is no contour of the next slice: an integer from 0, -1 at the end");
        }
        if (*index == -1) {
          if (next + 1 != lines_.words().size()) return wrong("words behind the -1");
          advance();
          return {};
        }
        adjacent_.push_back(
            {first_of_slice_.size() - 1, drawn().size() - 1, *index, lines_.line()});
      }
      advance();
      if (ended_) return wrong("the file ends within the adjacency of a contour, before its -1");
      next = 0;
    }
  }

  void resolve() {
    for (const Adjacent& adjacent : adjacent_) {
      const std::size_t next = adjacent.slice + 1;
      const std::size_t first = first_of_slice_[next];
      const std::size_t count =
          next + 1 < first_of_slice_.size() ? first_of_slice_[next + 1] - first : 0;
      if (adjacent.index >= static_cast<std::int64_t>(count)) {
        warnings_.add("there is no contour " + std::to_string(adjacent.index) +
                          " in the next slice, which has " + std::to_string(count) +
                          ": left out of the adjacency",
                      adjacent.text_line);
        continue;
      }
      drawing_.joins.push_back({adjacent.line, first + static_cast<std::size_t>(adjacent.index)});
    }
  }

  const Source& source_;
  TextLines lines_;
  WarningList warnings_;
  Drawing drawing_;
  std::vector<std::size_t>
      first_of_slice_;  // of each slice its first line, and one behind the last
  std::vector<Adjacent> adjacent_;
  bool ended_ = false;
};

Result<Drawing> read_slc(const Source& source, const ReadOptions& /*options*/) {
  return SlcReader(source).read();
}

}  // namespace

extern constinit const Format slc_format{
    .name = "slc",
    .summary = "slice contours with adjacency (Surface Reconstruction Library)",
    .extensions = {".slc"},
    .recognise = begins_as_slc,
    .read_drawing = read_slc};

}  // namespace tetloft::internal::io
