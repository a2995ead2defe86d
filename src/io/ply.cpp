// Boundary surfaces as .ply (Turk 1994): doubles, binary or text. Points and faces of any such
// file.
#include <cstdint>
#include <string>

#include "core/little_endian.hpp"
#include "io/format.hpp"
#include "io/numbers.hpp"
#include "io/ply_read.hpp"

namespace tetloft::internal::io {

namespace {

bool is_ply(std::string_view bytes) {
  return bytes.substr(0, 4) == "ply\n" || bytes.substr(0, 4) == "ply\r";
}

Written write_ply(Sink& sink, const SurfaceMesh& mesh, const Model& model, const Target& target) {
  const bool ascii = target.options.encoding == Encoding::ascii;
  const std::vector<SurfacePart> parts = surface_parts(mesh, model);
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "ply\nformat ";
  text += ascii ? "ascii" : "binary_little_endian";
  text += " 1.0\n";
  // A property of faces would tell components, too, but not every reader passes over those that
  // follow a list.
  for (const std::string& line : surface_comments(model, parts)) text += "comment " + line + '\n';
  text += "element vertex " + std::to_string(mesh.points.size()) +
          "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
          std::to_string(mesh.triangles.size()) +
          "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point3& p : mesh.points) {
    if (ascii) {
      append_point(text, p);
      text += '\n';
    } else {
      for (const double c : {p.x, p.y, p.z}) append_little(text, c);
    }
    pieces.next();
  }
  for (const std::uint32_t number : by_part(parts)) {
    const auto& triangle = mesh.triangles[number];
    if (ascii) {
      text += '3';
      for (const std::uint32_t v : triangle) {
        text += ' ';
        append_number(text, v);
      }
      text += '\n';
    } else {
      append_little(text, std::uint8_t{3});
      for (const std::uint32_t v : triangle) append_little(text, v);
    }
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format ply_format{.name = "ply",
                                         .summary = "Stanford polygons",
                                         .extensions = {".ply"},
                                         .recognise = is_ply,
                                         .read_points = read_ply_points,
                                         .read_triangles = read_ply_triangles,
                                         .write_surface = write_ply};

}  // namespace tetloft::internal::io
