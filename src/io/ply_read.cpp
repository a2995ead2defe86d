// Reading .ply (Turk 1994): a header that declares elements and their properties, then
// the elements one after the other.
#include "io/ply_read.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/little_endian.hpp"
#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/polygons.hpp"
#include "io/rows.hpp"
#include "io/scalar_type.hpp"
#include "io/volume/samples.hpp"

namespace tetloft::internal::io {

namespace {

constexpr std::array<ScalarName, 16> kPlyTypes{{{"char", ScalarType::int8},
                                                {"int8", ScalarType::int8},
                                                {"uchar", ScalarType::uint8},
                                                {"uint8", ScalarType::uint8},
                                                {"short", ScalarType::int16},
                                                {"int16", ScalarType::int16},
                                                {"ushort", ScalarType::uint16},
                                                {"uint16", ScalarType::uint16},
                                                {"int", ScalarType::int32},
                                                {"int32", ScalarType::int32},
                                                {"uint", ScalarType::uint32},
                                                {"uint32", ScalarType::uint32},
                                                {"float", ScalarType::float32},
                                                {"float32", ScalarType::float32},
                                                {"double", ScalarType::float64},
                                                {"float64", ScalarType::float64}}};

struct PlyProperty {
  std::string_view name;
  ScalarType type = ScalarType::float32;
  std::optional<ScalarType> count;  // of lists
};

struct PlyElement {
  std::string_view name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyForm : std::uint8_t { text, little, big };

class PlyReader {
 public:
  explicit PlyReader(const Source& source) : bytes_(source.bytes), name_(source.name) {}

  Result<ReadPoints> points() {
    if (Result<void> read = read_elements(false); !read) return read.error();
    return ReadPoints{polygons_.take(name_).mesh.points, std::move(warnings_)};
  }

  Result<ReadTriangles> triangles() {
    if (Result<void> read = read_elements(true); !read) return read.error();
    if (const auto missing = polygons_.missing()) {
      return complain("face " + std::to_string(missing->place) + " refers to vertex " +
                      std::to_string(missing->point) + " of " + std::to_string(polygons_.points()));
    }
    return polygons_.take(name_);
  }

 private:
  Error complain(const std::string& message) const {
    Error error = row_error(name_, line_, message);
    // Binary data have no lines.
    if (in_data_ && form_ != PlyForm::text) error.where.line.reset();
    return error;
  }

  std::optional<std::string_view> take_line() {
    if (at_ >= bytes_.size()) return std::nullopt;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    ++line_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  Result<void> read_head() {
    bool formed = false;
    for (bool first = true;; first = false) {
      const auto line = take_line();
      if (!line) return complain("the header does not end");
      std::vector<std::string_view> words;
      TextCursor cursor(*line);
      for (cursor.skip_white(); !cursor.at_end(); cursor.skip_white()) {
        if (words.size() == 8) break;
        words.push_back(cursor.token());
      }
      if (first) {
        if (words.size() != 1 || words[0] != "ply") return complain("this is no PLY");
        continue;
      }
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      Result<void> taken = take_words(words, formed);
      if (!taken) return taken;
    }
    if (!formed) return complain("the header names no format");
    in_data_ = true;
    return {};
  }

  Result<void> take_words(const std::vector<std::string_view>& words, bool& formed) {
    if (words[0] == "format" && words.size() > 1) {
      formed = true;
      form_ = words[1] == "ascii"                  ? PlyForm::text
              : words[1] == "binary_little_endian" ? PlyForm::little
                                                   : PlyForm::big;
      if (form_ != PlyForm::big || words[1] == "binary_big_endian") return {};
      return complain("unknown format " + in_quotes(words[1]));
    }
    if (words[0] == "element" && words.size() == 3) {
      const auto count = parse_integer(words[2]);
      if (!count || *count < 0) return complain(in_quotes(words[2]) + " is no count");
      elements_.push_back({words[1], static_cast<std::size_t>(*count), {}});
      return {};
    }
    if (words[0] != "property" || words.size() < 3 || elements_.empty()) {
      return complain("this is no line of a header: " + in_quotes(words[0]));
    }
    PlyProperty property;
    const bool list = words[1] == "list";
    if (words.size() != (list ? 5U : 3U)) return complain("a property has too many words, or few");
    const auto type = find_scalar(kPlyTypes, words[list ? 3 : 1]);
    if (list) property.count = find_scalar(kPlyTypes, words[2]);
    const bool countable = !list || (property.count && !is_float(*property.count));
    if (!type || !countable) return complain("a property has no known type");
    property.type = *type;
    property.name = words.back();
    elements_.back().properties.push_back(property);
    return {};
  }

  // The next value, at the end nothing.
  std::optional<double> take(ScalarType type) {
    if (form_ == PlyForm::text) {
      while (at_ < bytes_.size() && is_white(bytes_[at_])) line_ += bytes_[at_++] == '\n' ? 1U : 0U;
      const std::size_t from = at_;
      while (at_ < bytes_.size() && !is_white(bytes_[at_])) ++at_;
      const ParsedNumber number = parse_number(bytes_.substr(from, at_ - from));
      if (!number.ok()) return std::nullopt;
      return type == ScalarType::float32 ? static_cast<float>(number.value) : number.value;
    }
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) return std::nullopt;
    const char* const from = bytes_.data() + at_;
    at_ += size;
    return visit_scalar(type, [&](auto number) {
      return static_cast<double>(number_in<decltype(number)>(from, form_ == PlyForm::big));
    });
  }

  // Up to the last one that is needed.
  Result<void> read_elements(bool faces) {
    if (Result<void> head = read_head(); !head) return head;
    const auto find = [&](std::string_view name) {
      const auto found = std::find_if(elements_.begin(), elements_.end(),
                                      [&](const PlyElement& e) { return e.name == name; });
      return static_cast<std::size_t>(found - elements_.begin());
    };
    const std::size_t vertex = find("vertex");
    const std::size_t face = find("face");
    if (vertex == elements_.size()) return complain("the file has no element 'vertex'");
    if (faces && face == elements_.size()) return complain("the file has no element 'face'");
    const std::size_t last = faces ? std::max(vertex, face) : vertex;
    for (std::size_t e = 0; e <= last; ++e) {
      Result<void> read;
      if (e == vertex) {
        read = read_vertices(elements_[e]);
      } else if (faces && e == face) {
        read = read_faces(elements_[e]);
      } else {
        read = pass_over(elements_[e]);
      }
      if (!read) return read;
    }
    return {};
  }

  // Reads each of the element, and then calls done(); `value` is called with the property's number
  // and each value.
  template <class Value, class Done>
  Result<void> read_each(const PlyElement& element, Value&& value, Done&& done) {
    // An element without properties takes no bytes, however many there are.
    if (element.properties.empty()) return {};
    for (number_ = 0; number_ < element.count; ++number_) {
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        const auto count = property.count ? take(*property.count) : 1.0;
        bool taken = count && *count >= 0;
        for (double i = 0; taken && i < *count; ++i) {
          const auto one = take(property.type);
          taken = one.has_value();
          if (taken) value(p, *one);
        }
        if (!taken) {
          return complain(std::string(element.name) + ' ' + std::to_string(number_) + " of " +
                          std::to_string(element.count) + " is cut off, or no number");
        }
      }
      if (Result<void> good = done(); !good) return good;
    }
    return {};
  }

  Result<void> pass_over(const PlyElement& element) {
    return read_each(
        element, [](std::size_t, double) {}, [] { return Result<void>(); });
  }

  Result<void> read_vertices(const PlyElement& element) {
    std::array<std::size_t, 3> xyz{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view name = std::string_view("xyz").substr(i, 1);
      const auto found =
          std::find_if(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return p.name == name && !p.count; });
      if (found == element.properties.end()) {
        return complain("the vertices have no property " + in_quotes(name));
      }
      xyz[i] = static_cast<std::size_t>(found - element.properties.begin());
    }
    std::array<double, 3> point{};
    const auto value = [&](std::size_t p, double v) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (xyz[i] == p) point[i] = v;
      }
    };
    const auto done = [&]() -> Result<void> {
      if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2])) {
        return complain("vertex " + std::to_string(number_) + " is not finite");
      }
      polygons_.add_point({point[0], point[1], point[2]});
      return {};
    };
    Result<void> read = read_each(element, value, done);
    if (read) tell(element.properties.size() - 3);
    return read;
  }

  Result<void> read_faces(const PlyElement& element) {
    const auto list = std::find_if(
        element.properties.begin(), element.properties.end(), [](const PlyProperty& p) {
          return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
        });
    if (list == element.properties.end()) {
      return complain("the faces have no list 'vertex_indices' or 'vertex_index'");
    }
    const auto chosen = static_cast<std::size_t>(list - element.properties.begin());
    std::vector<std::uint32_t> corners;
    double wrong = 0;  // a number that is none of a vertex
    const auto value = [&](std::size_t p, double v) {
      if (p != chosen) return;
      const bool good = v >= 0 && v < UINT32_MAX && v == std::trunc(v);
      if (!good && wrong == 0) wrong = v == v ? v : -1;
      corners.push_back(good ? static_cast<std::uint32_t>(v) : 0);
    };
    const auto done = [&]() -> Result<void> {
      if (wrong != 0) {
        std::string text;
        append_number(text, wrong);
        return complain("face " + std::to_string(number_) + ": " + text +
                        " is no number of a vertex");
      }
      polygons_.add_polygon(corners, number_);
      corners.clear();
      return {};
    };
    return read_each(element, value, done);
  }

  void tell(std::size_t others) {
    if (others == 0) return;
    Warning warning{"left out: " + std::to_string(others) +
                        (others == 1 ? " property" : " properties") + " beside x, y and z",
                    {}};
    warning.where.file = name_;
    warnings_.push_back(std::move(warning));
  }

  std::string_view bytes_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  PlyForm form_ = PlyForm::text;
  bool in_data_ = false;
  std::vector<PlyElement> elements_;
  std::size_t number_ = 0;  // of the element at hand
  PolygonList polygons_;
  std::vector<Warning> warnings_;  // of points
};

}  // namespace

Result<ReadPoints> read_ply_points(const Source& source, const ReadOptions& /*options*/) {
  return PlyReader(source).points();
}

Result<ReadTriangles> read_ply_triangles(const Source& source, const ReadOptions& /*options*/) {
  return PlyReader(source).triangles();
}

}  // namespace tetloft::internal::io
