// Boundary surfaces as Wavefront .obj: text, all digits.
#include <cstdint>
#include <string>

#include "io/cursor.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

// A first vertex: "v" and three numbers; a section of a .cnt has other words there.
bool is_obj(std::string_view bytes) {
  TextCursor cursor(bytes);
  for (cursor.skip_white(); cursor.peek() == '#'; cursor.skip_white()) cursor.skip_line();
  if (cursor.token() != "v") return false;
  for (int i = 0; i < 3; ++i) {
    cursor.skip_blanks();
    if (!parse_number(cursor.token()).ok()) return false;
  }
  return true;
}

Written write_obj(Sink& sink, const SurfaceMesh& mesh, const Model& /*model*/,
                  const Target& /*target*/) {
  Pieces pieces(sink);
  for (const Point3& p : mesh.points) {
    pieces.text() += "v ";
    append_point(pieces.text(), p);
    pieces.text() += '\n';
    pieces.next();
  }
  for (const auto& triangle : mesh.triangles) {
    pieces.text() += 'f';
    for (const std::uint32_t v : triangle) {
      pieces.text() += ' ';
      append_number(pieces.text(), std::uint64_t{v} + 1);  // OBJ counts from 1
    }
    pieces.text() += '\n';
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format obj_format{.name = "obj",
                                         .summary = "Wavefront",
                                         .extensions = {".obj"},
                                         .recognise = is_obj,
                                         .write_surface = write_obj};

}  // namespace tetloft::internal::io
