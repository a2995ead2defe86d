// Reading surfaces of Wavefront .obj: lines "v x y z …" and "f 1/…/… 2 3 …"; what else a line may
// begin with says nothing of the surface.
#include "io/obj_read.hpp"

#include <array>
#include <string>
#include <vector>

#include "io/cursor.hpp"
#include "io/numbers.hpp"
#include "io/polygons.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

class ObjReader {
 public:
  explicit ObjReader(const Source& source) : cursor_(source.bytes), name_(source.name) {}

  Result<ReadTriangles> read() {
    for (cursor_.skip_white(); !cursor_.at_end(); cursor_.skip_white()) {
      const std::string_view word = cursor_.token(kWhiteOrComment);
      Result<void> taken;
      if (word == "v") taken = take_vertex();
      if (word == "f" || word == "fo") taken = take_face();
      if (!taken) return taken.error();
      skip_rest();
    }
    if (const auto missing = polygons_.missing()) {
      return row_error(name_, missing->place,
                       "a face refers to vertex " + std::to_string(missing->point + 1ULL) + " of " +
                           std::to_string(polygons_.points()));
    }
    return polygons_.take(name_);
  }

 private:
  // The next word of the line, which goes on behind a backslash at its end; empty at its end.
  std::string_view word() {
    for (;;) {
      cursor_.skip_blanks();
      if (cursor_.at_end() || cursor_.peek() == '\n' || cursor_.peek() == '#') return {};
      if (!at_continuation()) return cursor_.token(kWhiteOrComment);
      cursor_.advance();
      cursor_.skip_white();
    }
  }

  [[nodiscard]] bool at_continuation() const {
    const std::string_view rest = cursor_.rest();
    return rest.substr(0, 2) == "\\\n" || rest.substr(0, 3) == "\\\r\n";
  }

  void skip_rest() {
    while (!word().empty()) {
    }
    cursor_.skip_line();
  }

  Result<void> take_vertex() {
    std::array<double, 3> xyz{};
    for (double& c : xyz) {
      const std::string_view text = word();
      if (text.empty()) return row_error(name_, cursor_.line(), "a vertex has x, y and z");
      const ParsedNumber number = parse_number(text);
      if (!number.ok()) return row_error(name_, cursor_.line(), complaint(text, number.status));
      c = number.value;
    }
    polygons_.add_point({xyz[0], xyz[1], xyz[2]});
    return {};
  }

  Result<void> take_face() {
    const std::size_t line = cursor_.line();
    std::vector<std::uint32_t> corners;
    for (std::string_view text = word(); !text.empty(); text = word()) {
      const auto number = parse_integer(text.substr(0, text.find('/')));
      const auto count = static_cast<std::int64_t>(polygons_.points());
      const std::int64_t index = !number ? -1 : *number < 0 ? count + *number : *number - 1;
      if (index < 0 || index >= UINT32_MAX) {
        return row_error(
            name_, line,
            in_quotes(text) + " is no vertex: they count from 1, or backwards from -1");
      }
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    polygons_.add_polygon(corners, line);
    return {};
  }

  TextCursor cursor_;
  const std::string& name_;
  PolygonList polygons_;
};

}  // namespace

Result<ReadTriangles> read_obj(const Source& source, const ReadOptions& /*options*/) {
  return ObjReader(source).read();
}

}  // namespace tetloft::internal::io
