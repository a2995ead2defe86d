// NUAGES .cnt (Geiger, INRIA RR-2105, 1993), read in one pass:
//   S n            sections
//   v n z z        for each section: vertices, height
//   { x y x y … }  for each contour
// Both counts are redundant here; they are compared with what follows and used for nothing
// else.
#include <cmath>
#include <string>
#include <utility>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/arguments.hpp"
#include "io/cursor.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"

namespace tetloft {

namespace {

using io::complaint;
using io::in_quotes;
using io::ParsedNumber;

class CntReader {
 public:
  CntReader(std::string_view text, const std::string& name) : cursor_(text), name_(name) {}

  Result<ReadStack> read(Validity validity) {
    if (Result<void> known = io::check_validity(validity); !known) return known.error();
    if (Result<void> parsed = read_sections(); !parsed) return parsed.error();
    for (Warning& warning : mend(result_.stack)) {
      locate(warning.where);
      result_.warnings.push_back(std::move(warning));
    }
    if (validity == Validity::unchecked) return std::move(result_);
    if (Result<void> valid = validate(result_.stack); !valid) {
      Error error = valid.error();
      locate(error.where);
      return error;
    }
    return std::move(result_);
  }

 private:
  Result<void> read_sections() {
    cursor_.skip_white();
    if (cursor_.at_end()) return complain("the file is empty");
    const std::size_t header_line = cursor_.line();
    if (!take_letter('S')) return complain("expected 'S' and the number of sections");
    Result<double> sections = read_count("number of sections");
    if (!sections) return sections.error();
    for (cursor_.skip_white(); !cursor_.at_end(); cursor_.skip_white()) {
      if (Result<void> section = read_section(); !section) return section;
    }
    const std::size_t found = result_.stack.sections.size();
    if (*sections != static_cast<double>(found)) {
      warn("the header announces " + number_text(*sections) + " sections, the file has " +
               std::to_string(found),
           header_line);
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
    cursor_.skip_white();
    if (!take_letter('Z')) return complain("expected 'z' and the height of the section");
    Result<double> z = read_coordinate("height of the section");
    if (!z) return z.error();

    Section section;
    section.z = *z;
    IdVector<ContourId, std::size_t> lines;
    std::size_t vertices = 0;
    for (cursor_.skip_white(); cursor_.peek() == '{'; cursor_.skip_white()) {
      lines.push_back(cursor_.line());
      Contour contour;
      if (Result<void> parsed = read_contour(contour); !parsed) return parsed;
      vertices += contour.vertices.size();
      section.contours.push_back(std::move(contour));
    }
    const SectionId id = result_.stack.sections.push_back(std::move(section));
    result_.lines.push_back(std::move(lines));
    header_lines_.push_back(header_line);
    if (*announced != static_cast<double>(vertices)) {
      warn("the section announces " + number_text(*announced) + " vertices and has " +
               std::to_string(vertices),
           header_line, id);
    }
    return {};
  }

  // From the opening brace to behind the closing one.
  Result<void> read_contour(Contour& contour) {
    const std::size_t opened = cursor_.line();
    cursor_.advance();
    bool have_x = false;
    double x = 0;
    for (cursor_.skip_white(); cursor_.peek() != '}'; cursor_.skip_white()) {
      const std::string_view token = cursor_.token('{', '}');
      if (token.empty() || is_header(token)) {
        return complain("the contour opened in line " + std::to_string(opened) + " is not closed");
      }
      const ParsedNumber number = io::parse_number(token);
      if (!number.ok()) return complain(complaint(token, number.status));
      if (have_x) contour.vertices.push_back({x, number.value});
      x = number.value;
      have_x = !have_x;
    }
    if (have_x) {
      return complain("the contour opened in line " + std::to_string(opened) +
                      " has an odd number of coordinates");
    }
    cursor_.advance();
    return {};
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
    cursor_.skip_white();
    const std::string_view token = cursor_.token('{', '}');
    if (token.empty()) return complain(std::string("the ") + what + " is missing");
    const ParsedNumber number = io::parse_number(token);
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
      io::append_number(text, static_cast<long long>(value));
    } else {
      io::append_number(text, value);
    }
    return text;
  }

  [[nodiscard]] Error complain(const std::string& message) const {
    Error error{ErrorCode::invalid_input, message, {}};
    error.where.file = name_;
    error.where.line = cursor_.line();
    return error;
  }

  void warn(const std::string& message, std::size_t line, SectionId section = {}) {
    Warning warning{message, {}};
    warning.where.file = name_;
    warning.where.line = line;
    if (section.valid()) warning.where.section = section.index();
    result_.warnings.push_back(std::move(warning));
  }

  // Adds file and line to a place that names section and contour.
  void locate(Place& where) const {
    where.file = name_;
    if (!where.section || *where.section >= result_.lines.size()) return;
    const SectionId section(*where.section);
    where.line = header_lines_[section];
    const auto& lines = result_.lines[section];
    if (where.contour && *where.contour < lines.size()) {
      where.line = lines[ContourId(*where.contour)];
    }
  }

  io::TextCursor cursor_;
  const std::string& name_;
  ReadStack result_;
  // Line of each section's "v".
  IdVector<SectionId, std::size_t> header_lines_;
};

}  // namespace

Result<ReadStack> parse_cnt(std::string_view text, const std::string& name, Validity validity) {
  return guard_internal([&] { return CntReader(text, name).read(validity); });
}

Result<ReadStack> read_cnt(const std::string& path, Validity validity) {
  return guard_internal([&]() -> Result<ReadStack> {
    const Result<std::string> text = io::read_file(path);
    if (!text) return text.error();
    return CntReader(*text, path).read(validity);
  });
}

}  // namespace tetloft
