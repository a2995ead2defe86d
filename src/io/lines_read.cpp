// Line formats: labels of contours, and points in space (text or binary).
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <tetloft/io.hpp>

#include "core/check.hpp"
#include "io/bytes.hpp"
#include "io/cursor.hpp"
#include "io/files.hpp"
#include "io/numbers.hpp"

namespace tetloft {

namespace {

Error complain(const std::string& name, std::size_t line, const std::string& message) {
  Error error{ErrorCode::invalid_input, message, {}};
  error.where.file = name;
  error.where.line = line;
  return error;
}

// Calls row(line, fields) for every line with three fields, white space between them;
// `form` is what a line should look like. Blank lines and # comments are passed over.
template <class Row>
Result<void> for_each_row(std::string_view text, const std::string& name, const char* form,
                          Row&& row) {
  io::TextCursor cursor(text);
  for (cursor.skip_white(); !cursor.at_end(); cursor.skip_white()) {
    const std::size_t line = cursor.line();
    std::array<std::string_view, 3> fields;
    std::size_t count = 0;
    for (; !cursor.at_end() && cursor.peek() != '\n' && cursor.peek() != '#'; ++count) {
      const std::string_view field = cursor.token("#");
      if (count < fields.size()) fields[count] = field;
      cursor.skip_blanks();
    }
    cursor.skip_line();
    if (count == 0) continue;
    if (count != fields.size()) {
      return complain(name, line,
                      std::string("expected \"") + form + "\", got " + std::to_string(count) +
                          (count == 1 ? " field" : " fields"));
    }
    if (Result<void> taken = row(line, fields); !taken) return taken;
  }
  return {};
}

// Largest value of a section, contour or label: one less than an invalid id.
constexpr std::int64_t kLargestIndex = std::numeric_limits<std::uint32_t>::max() - 1;

Result<std::vector<Point3>> points_of_lines(std::string_view text, const std::string& name) {
  std::vector<Point3> points;
  const auto take = [&](std::size_t line,
                        const std::array<std::string_view, 3>& fields) -> Result<void> {
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const io::ParsedNumber number = io::parse_number(fields[i]);
      if (!number.ok()) return complain(name, line, io::complaint(fields[i], number.status));
      xyz[i] = number.value;
    }
    points.push_back({xyz[0], xyz[1], xyz[2]});
    return {};
  };
  if (Result<void> rows = for_each_row(text, name, "x y z", take); !rows) return rows.error();
  return points;
}

Result<std::vector<Point3>> decode_points(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kPointBytes = 3 * sizeof(double);
  if (bytes.size() % kPointBytes != 0) {
    Error error{ErrorCode::invalid_input,
                std::to_string(bytes.size()) + " bytes are no whole number of points (" +
                    std::to_string(kPointBytes) + " bytes each)",
                {}};
    error.where.file = name;
    return error;
  }
  std::vector<Point3> points(bytes.size() / kPointBytes);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char* const at = bytes.data() + i * kPointBytes;
    Point3& p = points[i];
    p = {io::load_little<double>(at), io::load_little<double>(at + 8),
         io::load_little<double>(at + 16)};
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    Error error{ErrorCode::invalid_input, "a coordinate is not finite", {}};
    error.where.file = name;
    error.where.vertex = i;
    error.where.point = p;
    return error;
  }
  return points;
}

}  // namespace

Result<std::vector<Label>> parse_labels(std::string_view text, const std::string& name) {
  return guard_internal([&]() -> Result<std::vector<Label>> {
    std::vector<Label> labels;
    const auto take = [&](std::size_t line,
                          const std::array<std::string_view, 3>& fields) -> Result<void> {
      std::array<std::int64_t, 3> values{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto value = io::parse_integer(fields[i]);
        if (!value || *value < 0 || *value > kLargestIndex) {
          return complain(name, line,
                          io::in_quotes(fields[i]) + " is no " +
                              (i == 0   ? "section"
                               : i == 1 ? "contour"
                                        : "label") +
                              ": expected an integer from 0");
        }
        values[i] = *value;
      }
      labels.push_back(
          {SectionId(values[0]), ContourId(values[1]), static_cast<std::uint32_t>(values[2])});
      return {};
    };
    Result<void> rows = for_each_row(text, name, "section contour label", take);
    if (!rows) return rows.error();
    return labels;
  });
}

Result<std::vector<Label>> read_labels(const std::string& path) {
  return guard_internal([&]() -> Result<std::vector<Label>> {
    const Result<std::string> text = io::read_file(path);
    if (!text) return text.error();
    return parse_labels(*text, path);
  });
}

Result<std::vector<Point3>> parse_points(std::string_view bytes, const std::string& name) {
  return guard_internal([&] {
    return io::extension_of(name) == ".bin" ? decode_points(bytes, name)
                                            : points_of_lines(bytes, name);
  });
}

Result<std::vector<Point3>> read_points(const std::string& path) {
  return guard_internal([&]() -> Result<std::vector<Point3>> {
    const Result<std::string> bytes = io::read_file(path);
    if (!bytes) return bytes.error();
    return parse_points(*bytes, path);
  });
}

}  // namespace tetloft
