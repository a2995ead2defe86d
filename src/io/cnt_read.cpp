// NUAGES .cnt (Geiger, INRIA RR-2105, 1993), read in one pass:
//   S n            sections
//   v n z z        for each section: vertices, height
//   { x y x y … }  for each contour
// Commas or semicolons may stand between numbers, # begins a comment. Both counts are redundant
// here: they are compared with what follows, and tell pairs from triples where that is open.
#include "io/cnt_read.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <tetloft/repair.hpp>
#include <tetloft/valid_stack.hpp>

#include "io/cnt_contents.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

class CntReader {
 public:
  CntReader(std::string_view text, const std::string& name) : cursor_(text), name_(name) {}

  Result<StackOfFile> read(const ReadOptions& options) {
    Result<void> parsed = read_sections();
    // Nothing is wrong before the first odd contour, whatever follows.
    if (!parsed && !contents_.odd) return parsed.error();
    Result<std::optional<Warning>> settled = settle_vertices(contents_);
    if (!settled) return with_file(settled.error());
    if (!parsed) return parsed.error();
    compare_counts();
    if (settled->has_value()) warn(**std::move(settled));
    mend_contours();
    if (options.close_on_frame) {
      if (Result<void> closed = close_lines(); !closed) return closed.error();
    }
    for (Warning& warning : suspicious_gaps(contents_.stack)) warn(std::move(warning));
    for (Warning& warning : open_lines(contents_.stack, kMostWarnings)) {
      warn(std::move(warning));
    }
    sum_up();
    IdVector<SectionId, Nesting> nestings;
    if (options.validity == Validity::required) {
      auto nested = nest_if_valid(contents_.stack, {.threads = 1});
      if (!nested) return refusal(nested.error());
      nestings = *std::move(nested);
    }
    return StackOfFile{
        {std::move(contents_.stack), std::move(warnings_), std::move(contents_.lines)},
        std::move(nestings)};
  }

 private:
  Result<void> read_sections() {
    skip_space();
    if (cursor_.at_end()) return complain("the file is empty");
    header_line_ = cursor_.line();
    if (!take_letter('S')) return complain("expected 'S' and the number of sections");
    Result<double> sections = read_count("number of sections");
    if (!sections) return sections.error();
    announced_sections_ = *sections;
    for (skip_space(); !cursor_.at_end(); skip_space()) {
      if (Result<void> section = read_section(); !section) return section;
    }
    return {};
  }

  Result<void> read_section() {
    const std::size_t header_line = cursor_.line();
    if (!take_letter('V')) {
      return complain("expected 'v' (a section), '{' (a contour) or the end of the file, got " +
                      in_quotes(cursor_.token()));
    }
    Result<double> announced = read_count("number of vertices");
    if (!announced) return announced.error();
    skip_space();
    if (!take_letter('Z')) return complain("expected 'z' and the height of the section");
    Result<double> z = read_coordinate("height of the section");
    if (!z) return z.error();

    const SectionId id = contents_.stack.sections.push_back({*z, {}});
    contents_.lines.push_back({});
    contents_.header_lines.push_back(header_line);
    contents_.announced.push_back(*announced);
    for (skip_space(); cursor_.peek() == '{'; skip_space()) {
      if (Result<void> parsed = read_contour(id); !parsed) return parsed;
    }
    return {};
  }

  // From the opening brace to behind the closing one.
  Result<void> read_contour(SectionId section) {
    const std::size_t opened = cursor_.line();
    contents_.lines[section].push_back(opened);
    const ContourId id = contents_.stack.sections[section].contours.push_back({});
    std::vector<Point2>& vertices = contents_.stack.sections[section].contours[id].vertices;
    cursor_.advance();
    bool have_x = false;
    double x = 0;
    for (skip_space(); cursor_.peek() != '}'; skip_separator()) {
      const char next = cursor_.peek();
      if (next == ',' || next == ';') {
        return complain(std::string("a number is missing before '") + next + '\'');
      }
      const std::string_view token = cursor_.token(kStops);
      if (token.empty() || is_header(token)) {
        return complain("the contour opened in line " + std::to_string(opened) + " is not closed");
      }
      const ParsedNumber number = parse_number(token);
      if (!number.ok()) return complain(complaint(token, number.status));
      if (have_x) vertices.push_back({x, number.value});
      x = number.value;
      have_x = !have_x;
    }
    if (have_x) {
      vertices.push_back({x, std::numeric_limits<double>::quiet_NaN()});
      if (!contents_.odd) contents_.odd = {opened, cursor_.line()};
    }
    cursor_.advance();
    vertices.shrink_to_fit();
    return {};
  }

  // White space and comments.
  void skip_space() {
    for (cursor_.skip_white(); cursor_.peek() == '#'; cursor_.skip_white()) cursor_.skip_line();
  }

  // What may follow a number: one comma or semicolon, with space around.
  void skip_separator() {
    skip_space();
    const char next = cursor_.peek();
    if (next != ',' && next != ';') return;
    if (next == ',') contents_.commas = true;
    cursor_.advance();
    skip_space();
  }

  void compare_counts() {
    for (std::size_t s = 0; s < contents_.stack.sections.size(); ++s) {
      const SectionId id(s);
      std::size_t vertices = 0;
      for (const Contour& contour : contents_.stack.sections[id].contours.raw()) {
        vertices += contour.vertices.size();
      }
      if (contents_.announced[id] == static_cast<double>(vertices)) continue;
      warn_at("the section announces " + number_text(contents_.announced[id]) +
                  " vertices and has " + std::to_string(vertices),
              contents_.header_lines[id], id);
    }
    const std::size_t found = contents_.stack.sections.size();
    if (announced_sections_ == static_cast<double>(found)) return;
    warn_at("the header announces " + number_text(announced_sections_) +
                " sections, the file has " + std::to_string(found),
            header_line_);
  }

  // One contour after the other: the warnings of a whole file may be larger than the file.
  void mend_contours() {
    for (std::size_t s = 0; s < contents_.stack.sections.size(); ++s) {
      Section& section = contents_.stack.sections[SectionId(s)];
      for (std::size_t c = 0; c < section.contours.size(); ++c) {
        Contour& contour = section.contours[ContourId(c)];
        if (contour.vertices.size() < 2) continue;
        SectionStack alone;
        alone.sections.push_back({section.z, {}});
        auto& contours = alone.sections[SectionId(0)].contours;
        contours.push_back(std::move(contour));
        for (Warning& warning : mend(alone)) {
          warning.where.section = s;
          warning.where.contour = c;
          warn(std::move(warning));
        }
        contour = std::move(contours[ContourId(0)]);
      }
    }
  }

  static bool is_header(std::string_view token) {
    return token == "v" || token == "V" || token == "S" || token == "s";
  }

  // Passes over `upper` in either case.
  bool take_letter(char upper) {
    const char c = cursor_.peek();
    if (c != upper && c != static_cast<char>(upper - 'A' + 'a')) return false;
    cursor_.advance();
    return true;
  }

  Result<double> read_coordinate(const char* what) {
    skip_space();
    const std::string_view token = cursor_.token(kStops);
    if (token.empty()) return complain(std::string("the ") + what + " is missing");
    const ParsedNumber number = parse_number(token);
    if (!number.ok()) {
      return complain(std::string("the ") + what + ' ' + complaint(token, number.status));
    }
    return number.value;
  }

  Result<double> read_count(const char* what) {
    Result<double> count = read_coordinate(what);
    if (!count) return count;
    if (*count < 0 || *count != std::floor(*count)) {
      return complain(std::string("the ") + what + " is " + number_text(*count) +
                      ", which is no count");
    }
    return count;
  }

  static std::string number_text(double value) {
    std::string text;
    if (std::fabs(value) < 0x1p63 && value == std::floor(value)) {
      append_number(text, static_cast<long long>(value));
    } else {
      append_number(text, value);
    }
    return text;
  }

  [[nodiscard]] Error complain(const std::string& message) const {
    Error error{ErrorCode::invalid_input, message, {}};
    error.where.file = name_;
    error.where.line = cursor_.line();
    return error;
  }

  Result<void> close_lines() {
    const std::vector<ContourOfSection> lines = lines_to_the_frame(contents_.stack);
    Result<ClosedOnFrame> closed = close_on_frame(contents_.stack, lines);
    if (!closed) {
      Error error = closed.error();
      locate(error.where);
      return error;
    }
    for (Warning& change : closed->changes) warn(std::move(change));
    if (lines.empty()) warn({"no line is open: nothing is closed along a frame", {}});
    contents_.stack = std::move(closed->stack);
    for (const SectionId s : contents_.stack.sections.ids()) {
      IdVector<ContourId, std::size_t> of_contours;
      for (const ContourId of : closed->origin[s]) {
        of_contours.push_back(of.valid() ? contents_.lines[s][of] : contents_.header_lines[s]);
      }
      contents_.lines[s] = std::move(of_contours);
    }
    return {};
  }

  void warn_at(const std::string& message, std::size_t line, SectionId section = {}) {
    Warning warning{message, {}};
    warning.where.line = line;
    if (section.valid()) warning.where.section = section.index();
    warn(std::move(warning));
  }

  void warn(Warning warning) {
    if (warnings_.size() >= kMostWarnings) {
      ++untold_;
      return;
    }
    locate(warning.where);
    warnings_.push_back(std::move(warning));
  }

  void sum_up() {
    if (untold_ == 0) return;
    Warning warning{"and " + std::to_string(untold_) + " more warnings of this file", {}};
    warning.where.file = name_;
    warnings_.push_back(std::move(warning));
  }

  // What validate() refuses; where a contour may be an open line, that is why.
  Error refusal(Error error) {
    locate(error.where);
    if (!error.where.section || !error.where.contour) return error;
    const auto& contours = contents_.stack.sections[SectionId(*error.where.section)].contours;
    const auto times = conspicuous_closing(contours[ContourId(*error.where.contour)]);
    if (!times) return error;
    error.message += "; the edge that closes the contour is " + number_text(std::floor(*times)) +
                     " times as long as its longest other: if it is an open line, close it along "
                     "the frame (--close-on-frame)";
    return error;
  }

  [[nodiscard]] Error with_file(Error error) const {
    error.where.file = name_;
    return error;
  }

  // Adds file and line to a place that names section and contour.
  void locate(Place& where) const {
    where.file = name_;
    if (where.line || !where.section || *where.section >= contents_.lines.size()) return;
    const SectionId section(*where.section);
    where.line = contents_.header_lines[section];
    const auto& lines = contents_.lines[section];
    if (where.contour && *where.contour < lines.size()) {
      where.line = lines[ContourId(*where.contour)];
    }
  }

  // Where a number ends.
  static constexpr TokenEnds kStops{"{},;#"};
  // A file of a million slips gets this many warnings, and one that counts the others.
  static constexpr std::size_t kMostWarnings = 1000;

  TextCursor cursor_;
  const std::string& name_;
  CntContents contents_;
  std::vector<Warning> warnings_;
  std::size_t untold_ = 0;
  std::size_t header_line_ = 0;
  double announced_sections_ = 0;
};

}  // namespace

Result<StackOfFile> read_cnt_source(const Source& source, const ReadOptions& options) {
  return CntReader(source.bytes, source.name).read(options);
}

}  // namespace tetloft::internal::io
