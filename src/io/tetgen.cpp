// Solids as TetGen has them (H. Si, TetGen: a quality tetrahedral mesh generator, user's manual,
// section "File formats"): tets in .ele, points in .node, the boundary in .face. All are numbered
// from 0, as in .vtu.
#include <cstdint>
#include <string>

#include "io/format.hpp"
#include "io/group_number.hpp"
#include "io/numbers.hpp"
#include "io/solid_comments.hpp"
#include "io/tetgen_read.hpp"

namespace tetloft::internal::io {

namespace {

template <class Corners>
void append_tetgen_row(std::string& text, std::size_t number, const Corners& corners,
                       std::int64_t mark) {
  append_number(text, number);
  for (const VertexId v : corners) {
    text += ' ';
    append_number(text, v.value());
  }
  text += ' ';
  append_number(text, mark);
  text += '\n';
}

// The region attribute is the number of the component.
Written write_ele(Sink& sink, const Model& model, const Target& /*target*/) {
  Pieces pieces(sink);
  append_comments(pieces.text(), "#", model, component_groups(model));
  pieces.text() += std::to_string(model.tets.size()) + " 4 1\n";
  for (const TetId t : model.tets.ids()) {
    append_tetgen_row(pieces.text(), t.index(), model.tets[t], group_number(model, t));
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

Written write_node(Sink& sink, const Model& model, const Target& /*target*/) {
  Pieces pieces(sink);
  pieces.text() = std::to_string(model.points.size()) + " 3 0 0\n";
  for (const VertexId v : model.points.ids()) {
    append_number(pieces.text(), v.value());
    pieces.text() += ' ';
    append_point(pieces.text(), model.points[v]);
    pieces.text() += '\n';
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

// Outward, with the number of the component behind each as boundary marker.
Written write_face(Sink& sink, const Model& model, const Target& /*target*/) {
  const Surface surface = boundary_surface(model);
  Pieces pieces(sink);
  pieces.text() = std::to_string(surface.triangles.size()) + " 1\n";
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    append_tetgen_row(pieces.text(), i, surface.triangles[i], group_number(model, surface.tet[i]));
    pieces.next();
  }
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format tetgen_format{
    .name = "tetgen",
    .summary = "TetGen, .node and .face beside it",
    .extensions = {".ele"},
    .read_model = read_tetgen,
    .write_model = write_ele,
    .companions = {Companion{".node", write_node}, Companion{".face", write_face}}};

}  // namespace tetloft::internal::io
