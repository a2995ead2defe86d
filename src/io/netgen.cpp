// Solids as Netgen's .vol, which NGSolve reads (libsrc/meshing/meshclass.cpp of Netgen): a material
// and a boundary condition for each component, with its name, numbered from 1 without gaps, as
// Netgen needs it. No comments: Netgen takes the words in them for its own. Netgen's tets are
// negative; its triangles are outward, as ours are.
#include <cstdint>
#include <string>
#include <vector>

#include "io/format.hpp"
#include "io/group_number.hpp"
#include "io/label_names.hpp"
#include "io/numbers.hpp"

namespace tetloft::internal::io {

namespace {

void append_netgen_corner(std::string& text, VertexId v) {
  text += ' ';
  append_number(text, std::uint64_t{v.value()} + 1);
}

void append_netgen_boundary(Pieces& pieces, const Model& model,
                            const IdVector<TetId, std::size_t>& places) {
  const Surface surface = boundary_surface(model);
  std::string& text = pieces.text();
  text += "# surfnr bcnr domin domout np p1 p2 p3\nsurfaceelements\n" +
          std::to_string(surface.triangles.size()) + '\n';
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const std::string number = std::to_string(places[surface.tet[i]] + 1);
    text += number + ' ' + number + ' ' + number + " 0 3";
    for (const VertexId v : surface.triangles[i]) append_netgen_corner(text, v);
    text += '\n';
    pieces.next();
  }
}

void append_netgen_tets(Pieces& pieces, const Model& model,
                        const IdVector<TetId, std::size_t>& places) {
  std::string& text = pieces.text();
  text += "# matnr np p1 p2 p3 p4\nvolumeelements\n" + std::to_string(model.tets.size()) + '\n';
  for (const TetId t : model.tets.ids()) {
    append_number(text, places[t] + 1);
    text += " 4";
    for (const std::size_t k : {0U, 2U, 1U, 3U}) append_netgen_corner(text, model.tets[t][k]);
    text += '\n';
    pieces.next();
  }
}

// Names are words. Those of boundaries are others: readers may keep all in one table.
void append_netgen_names(Pieces& pieces, const char* section,
                         const std::vector<std::string>& labels, const char* ending) {
  std::string& text = pieces.text();
  text += std::string(section) + '\n' + std::to_string(labels.size()) + '\n';
  for (std::size_t g = 0; g < labels.size(); ++g) {
    append_number(text, g + 1);
    text += ' ' + labels[g] + ending + '\n';
    pieces.next();
  }
}

Written write_netgen(Sink& sink, const Model& model, const Target& /*target*/) {
  const std::vector<ComponentGroup> groups = component_groups(model);
  const IdVector<TetId, std::size_t> places = group_places(model, groups);
  const std::vector<std::string> labels = label_names(groups);
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "mesh3d\ndimension\n3\ngeomtype\n0\n\n";
  append_netgen_boundary(pieces, model, places);
  append_netgen_tets(pieces, model, places);
  text += "points\n" + std::to_string(model.points.size()) + '\n';
  for (const Point3& p : model.points) {
    append_point(text, p);
    text += '\n';
    pieces.next();
  }
  append_netgen_names(pieces, "materials", labels, "");
  append_netgen_names(pieces, "bcnames", labels, "_BOUNDARY");
  text += "endmesh\n";
  pieces.finish();
  return std::vector<Warning>();
}

}  // namespace

extern constinit const Format netgen_format{.name = "netgen",
                                            .summary = "Netgen, NGSolve",
                                            .extensions = {".vol"},
                                            .write_model = write_netgen};

}  // namespace tetloft::internal::io
