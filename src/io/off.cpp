// Surfaces as .off (Geomview): "OFF", counts, a line for each vertex and each face.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/cursor.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/polygons.hpp"
#include "io/rows.hpp"

namespace tetloft::internal::io {

namespace {

// The first word: "OFF", before it letters that announce further numbers behind x, y, z (texture
// coordinates, colours, normals). Some programs write the counts without a space behind it.
struct OffHead {
  bool known = false;
  bool other_dimension = false;
  std::string_view rest;  // behind "OFF"
};

OffHead off_head(std::string_view word) {
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) return {};
  std::string_view letters = word.substr(0, at);
  for (const std::string_view letter : {"ST", "C", "N"}) {
    if (letters.substr(0, letter.size()) == letter) letters.remove_prefix(letter.size());
  }
  const bool other = letters == "4" || letters == "n" || letters == "4n";
  const std::string_view rest = word.substr(at + 3);
  if ((!letters.empty() && !other) || (!rest.empty() && !is_digit(rest.front()))) return {};
  return {true, other, rest};
}

bool is_off(std::string_view bytes) {
  TextCursor cursor(bytes);
  for (cursor.skip_white(); cursor.peek() == '#'; cursor.skip_white()) cursor.skip_line();
  return off_head(cursor.token()).known;
}

class OffReader {
 public:
  explicit OffReader(const Source& source) : cursor_(source.bytes), name_(source.name) {}

  Result<ReadTriangles> read() {
    if (Result<void> head = read_head(); !head) return head.error();
    for (std::size_t v = 0; v < vertices_; ++v) {
      if (Result<void> taken = take_vertex(v); !taken) return taken.error();
    }
    for (std::size_t f = 0; f < faces_; ++f) {
      if (Result<void> taken = take_face(f); !taken) return taken.error();
    }
    if (go_to_word()) return complain("something follows the last face that is announced");
    return polygons_.take(name_);
  }

 private:
  Error complain(const std::string& message) const {
    return row_error(name_, cursor_.line(), message);
  }

  // Over empty lines and comments; false at the end.
  bool go_to_word() {
    for (cursor_.skip_white(); cursor_.peek() == '#'; cursor_.skip_white()) cursor_.skip_line();
    return !cursor_.at_end();
  }

  std::string_view next() {
    return go_to_word() ? cursor_.token(kWhiteOrComment) : std::string_view();
  }

  // Colours may follow on the line, how many only the line tells.
  void skip_rest() { cursor_.skip_line(); }

  Result<void> read_head() {
    go_to_word();
    TextCursor ahead = cursor_;
    const OffHead head = off_head(ahead.token(kWhiteOrComment));
    std::string_view word = head.rest;
    if (head.known) next();
    if (head.other_dimension) return complain("points of other than three dimensions");
    std::array<std::size_t, 2> counts{};
    for (std::size_t& count : counts) {
      if (word.empty()) word = next();
      if (word == "BINARY") return complain("binary OFF is not read; save it as text");
      const auto number = parse_integer(word);
      if (!number || *number < 0 || *number >= UINT32_MAX) {
        return complain(in_quotes(word) +
                        " is no count: \"OFF\", then those of vertices and faces");
      }
      count = static_cast<std::size_t>(*number);
      word = {};
    }
    vertices_ = counts[0];
    faces_ = counts[1];
    skip_rest();  // the count of edges, which some leave out
    return {};
  }

  Result<void> take_vertex(std::size_t v) {
    std::array<double, 3> xyz{};
    for (double& c : xyz) {
      const std::string_view text = next();
      if (text.empty()) return ends("vertices", v, vertices_);
      const ParsedNumber number = parse_number(text);
      if (!number.ok()) return complain(complaint(text, number.status));
      c = number.value;
    }
    polygons_.add_point({xyz[0], xyz[1], xyz[2]});
    skip_rest();
    return {};
  }

  Result<void> take_face(std::size_t f) {
    const std::string_view text = next();
    if (text.empty()) return ends("faces", f, faces_);
    const auto count = parse_integer(text);
    if (!count || *count < 0) return complain(in_quotes(text) + " is no count of corners");
    std::vector<std::uint32_t> corners;
    for (std::int64_t k = 0; k < *count; ++k) {
      const std::string_view corner = next();
      if (corner.empty()) return ends("faces", f, faces_);
      const auto number = parse_integer(corner);
      if (!number || *number < 0 || static_cast<std::uint64_t>(*number) >= vertices_) {
        return complain(in_quotes(corner) + " is none of the " + std::to_string(vertices_) +
                        " vertices, which count from 0");
      }
      corners.push_back(static_cast<std::uint32_t>(*number));
    }
    polygons_.add_polygon(corners, f);
    skip_rest();
    return {};
  }

  Error ends(const char* what, std::size_t here, std::size_t announced) const {
    return complain(std::string(what) + ": " + std::to_string(announced) +
                    " are announced, the file ends after " + std::to_string(here));
  }

  TextCursor cursor_;
  const std::string& name_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  PolygonList polygons_;
};

Result<ReadTriangles> read_off(const Source& source, const ReadOptions& /*options*/) {
  return OffReader(source).read();
}

Written write_off(Sink& sink, const SurfaceMesh& mesh, const Model& model,
                  const Target& /*target*/) {
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  Pieces pieces(sink);
  pieces.text() = "OFF\n";
  for (const std::string& line : surface_comments(model, parts)) {
    pieces.text() += "# " + line + '\n';
  }
  pieces.text() +=
      std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Point3& p : mesh.points) {
    append_point(pieces.text(), p);
    pieces.text() += '\n';
    pieces.next();
  }
  for (const std::uint32_t triangle : by_part(parts)) {
    pieces.text() += '3';
    for (const std::uint32_t v : mesh.triangles[triangle]) {
      pieces.text() += ' ';
      append_number(pieces.text(), v);
    }
    pieces.text() += '\n';
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format off_format{.name = "off",
                                         .summary = "Geomview",
                                         .extensions = {".off"},
                                         .recognise = is_off,
                                         .read_triangles = read_off,
                                         .write_surface = write_off};

}  // namespace tetloft::internal::io
