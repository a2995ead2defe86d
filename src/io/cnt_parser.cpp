#include "io/cnt_parser.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// Where a number of a .cnt ends.
constexpr TokenEnds kNumberEnds{"{},;#"};

bool is_header_letter(std::string_view token) {
  return token == "v" || token == "V" || token == "S" || token == "s";
}

}  // namespace

Result<CntParser::Header> CntParser::header() {
  if (!more()) return complain("the file is empty");
  Header header{cursor_.line(), 0};
  if (!take_letter('S')) return complain("expected 'S' and the number of sections");
  Result<double> sections = count("number of sections");
  if (!sections) return sections.error();
  header.sections = *sections;
  return header;
}

bool CntParser::more() {
  skip_space();
  return !cursor_.at_end();
}

Result<void> CntParser::section(CntContents& contents) {
  const std::size_t header_line = cursor_.line();
  if (!take_letter('V')) {
    return complain("expected 'v' (a section), '{' (a contour) or the end of the file, got " +
                    in_quotes(cursor_.token()));
  }
  Result<double> announced = count("number of vertices");
  if (!announced) return announced.error();
  skip_space();
  if (!take_letter('Z')) return complain("expected 'z' and the height of the section");
  Result<double> z = coordinate("height of the section");
  if (!z) return z.error();

  const SectionId id = contents.stack.sections.push_back({*z, {}});
  contents.lines.push_back({});
  contents.header_lines.push_back(header_line);
  contents.announced.push_back(*announced);
  for (skip_space(); cursor_.peek() == '{'; skip_space()) {
    if (Result<void> parsed = contour(contents, id); !parsed) return parsed;
  }
  return {};
}

// From the opening brace to behind the closing one.
Result<void> CntParser::contour(CntContents& contents, SectionId section) {
  const std::size_t opened = cursor_.line();
  contents.lines[section].push_back(opened);
  const ContourId id = contents.stack.sections[section].contours.push_back({});
  std::vector<Point2>& vertices = contents.stack.sections[section].contours[id].vertices;
  cursor_.advance();
  bool have_x = false;
  double x = 0;
  for (skip_space(); cursor_.peek() != '}'; skip_separator(contents)) {
    const char next = cursor_.peek();
    if (next == ',' || next == ';') {
      return complain(std::string("a number is missing before '") + next + '\'');
    }
    const std::string_view token = cursor_.token(kNumberEnds);
    if (token.empty() || is_header_letter(token)) {
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
    if (!contents.odd) contents.odd = {opened, cursor_.line()};
  }
  cursor_.advance();
  vertices.shrink_to_fit();
  return {};
}

// White space and comments.
void CntParser::skip_space() {
  for (cursor_.skip_white(); cursor_.peek() == '#'; cursor_.skip_white()) cursor_.skip_line();
}

// What may follow a number: one comma or semicolon, with space around.
void CntParser::skip_separator(CntContents& contents) {
  skip_space();
  const char next = cursor_.peek();
  if (next != ',' && next != ';') return;
  if (next == ',') contents.commas = true;
  cursor_.advance();
  skip_space();
}

// Passes over `upper` in either case.
bool CntParser::take_letter(char upper) {
  const char c = cursor_.peek();
  if (c != upper && c != static_cast<char>(upper - 'A' + 'a')) return false;
  cursor_.advance();
  return true;
}

Result<double> CntParser::coordinate(const char* what) {
  skip_space();
  const std::string_view token = cursor_.token(kNumberEnds);
  if (token.empty()) return complain(std::string("the ") + what + " is missing");
  const ParsedNumber number = parse_number(token);
  if (!number.ok()) {
    return complain(std::string("the ") + what + ' ' + complaint(token, number.status));
  }
  return number.value;
}

Result<double> CntParser::count(const char* what) {
  Result<double> count = coordinate(what);
  if (!count) return count;
  if (*count < 0 || *count != std::floor(*count)) {
    return complain(std::string("the ") + what + " is " + count_text(*count) +
                    ", which is no count");
  }
  return count;
}

Error CntParser::complain(const std::string& message) const {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name_;
  error.where.line = cursor_.line();
  return error;
}

std::string count_text(double value) {
  std::string text;
  if (std::fabs(value) < 0x1p63 && value == std::floor(value)) {
    append_number(text, static_cast<long long>(value));
  } else {
    append_number(text, value);
  }
  return text;
}

}  // namespace tetloft::internal::io
