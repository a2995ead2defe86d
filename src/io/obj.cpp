// Surfaces as Wavefront .obj: text, all digits, an object and a group for each component.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "io/cursor.hpp"
#include "io/description_texts.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/obj_read.hpp"

namespace tetloft::internal::io {

namespace {

// A first vertex: "v" and three numbers; a section of a .cnt has other words there. Before it,
// names of objects, groups and materials.
bool is_obj(std::string_view bytes) {
  constexpr std::array<std::string_view, 5> kNames{"mtllib", "usemtl", "o", "g", "s"};
  constexpr int kMostLines = 100;
  TextCursor cursor(bytes);
  for (int line = 0; line < kMostLines; ++line) {
    cursor.skip_white();
    if (cursor.peek() == '#') {
      cursor.skip_line();
      continue;
    }
    const std::string_view word = cursor.token();
    if (word == "v") break;
    if (std::find(kNames.begin(), kNames.end(), word) == kNames.end()) return false;
    cursor.skip_line();
  }
  for (int i = 0; i < 3; ++i) {
    cursor.skip_blanks();
    if (!parse_number(cursor.token()).ok()) return false;
  }
  return true;
}

// A line goes on behind a backslash at its end.
std::string obj_text(std::string text) {
  if (text.ends_with('\\')) text.back() = '/';
  return text;
}

// Some readers tell objects apart, some groups. The name of a group is one word: those behind a
// blank are further groups.
std::string part_head(const SurfacePart& part) {
  const std::string name = obj_text(printable(part.name));
  std::string group = name;
  std::replace(group.begin(), group.end(), ' ', '_');
  return "o " + name + "\ng " + group + '\n';
}

Written write_obj(Sink& sink, const SurfaceMesh& mesh, const Model& model,
                  const Target& /*target*/) {
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  Pieces pieces(sink);
  for (const std::string& line : description_lines(model.about)) {
    pieces.text() += "# " + obj_text(line) + '\n';
  }
  for (const Point3& p : mesh.points) {
    pieces.text() += "v ";
    append_point(pieces.text(), p);
    pieces.text() += '\n';
    pieces.next();
  }
  for (const SurfacePart& part : parts) {
    if (!is_nameless(model, parts)) pieces.text() += part_head(part);
    for (const std::uint32_t triangle : part.triangles) {
      pieces.text() += 'f';
      for (const std::uint32_t v : mesh.triangles[triangle]) {
        pieces.text() += ' ';
        append_number(pieces.text(), std::uint64_t{v} + 1);  // OBJ counts from 1
      }
      pieces.text() += '\n';
      pieces.next();
    }
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format obj_format{.name = "obj",
                                         .summary = "Wavefront",
                                         .extensions = {".obj"},
                                         .recognise = is_obj,
                                         .read_triangles = read_obj,
                                         .write_surface = write_obj};

}  // namespace tetloft::internal::io
