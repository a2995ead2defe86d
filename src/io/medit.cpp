// Solids as MEDIT's .mesh (P. Frey, MEDIT: an interactive mesh visualization software, INRIA
// RT-0253, 2001), which Mmg, FreeFem, Gmsh and others read: text, numbers of double precision.
#include <string>

#include "io/cursor.hpp"
#include "io/format.hpp"
#include "io/group_number.hpp"
#include "io/medit_read.hpp"
#include "io/numbers.hpp"
#include "io/solid_comments.hpp"

namespace tetloft::internal::io {

namespace {

bool is_medit(std::string_view bytes) {
  TextCursor cursor(bytes);
  for (cursor.skip_white(); cursor.peek() == '#'; cursor.skip_white()) cursor.skip_line();
  return cursor.token() == "MeshVersionFormatted";
}

template <class Corners>
void append_medit_row(std::string& text, const Corners& corners, std::int64_t reference) {
  for (const VertexId v : corners) {
    append_number(text, std::uint64_t{v.value()} + 1);
    text += ' ';
  }
  append_number(text, reference);
  text += '\n';
}

Written write_medit(Sink& sink, const Model& model, const Target& /*target*/) {
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "MeshVersionFormatted 2\n";
  append_comments(text, "#", model, component_groups(model));
  text += "Dimension 3\n\nVertices\n" + std::to_string(model.points.size()) + '\n';
  for (const Point3& p : model.points) {
    append_point(text, p);
    text += " 0\n";
    pieces.next();
  }
  text += "\nTetrahedra\n" + std::to_string(model.tets.size()) + '\n';
  for (const TetId t : model.tets.ids()) {
    append_medit_row(text, model.tets[t], group_number(model, t));
    pieces.next();
  }
  const Surface surface = boundary_surface(model);
  text += "\nTriangles\n" + std::to_string(surface.triangles.size()) + '\n';
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    append_medit_row(text, surface.triangles[i], group_number(model, surface.tet[i]));
    pieces.next();
  }
  text += "\nEnd\n";
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format medit_format{.name = "medit",
                                           .summary = "MEDIT mesh",
                                           .extensions = {".mesh"},
                                           .recognise = is_medit,
                                           .read_model = read_medit,
                                           .write_model = write_medit};

}  // namespace tetloft::internal::io
