// Solids as a deck of Abaqus, which CalculiX reads as well (Abaqus keywords reference; CalculiX
// CrunchiX user's manual): the mesh alone, to be included by the deck of an analysis.
//
// Nodes and elements are numbered from 1 in the order of the model. An element's faces are S1 (of
// its nodes 1 2 3), S2 (1 4 2), S3 (2 4 3) and S4 (3 4 1).
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "io/fitted_number.hpp"
#include "io/format.hpp"
#include "io/group_number.hpp"
#include "io/label_names.hpp"
#include "io/numbers.hpp"
#include "io/solid_comments.hpp"

namespace tetloft::internal::io {

namespace {

// As many characters of a number are read.
constexpr std::size_t kDeckWidth = 20;

constexpr const char* kDeckNodes = "ALL_NODES";
constexpr const char* kDeckElements = "ALL_ELEMENTS";
constexpr const char* kDeckBoundary = "BOUNDARY";
constexpr const char* kDeckBoundaryNodes = "BOUNDARY_NODES";

// By the vertex that lies opposite.
constexpr std::array<const char*, 4> kDeckFaces{"S3", "S4", "S2", "S1"};

void append_deck_ids(std::string& text, std::size_t number, const TetVertices& corners) {
  append_number(text, number);
  for (const VertexId v : corners) {
    text += ", ";
    append_number(text, std::uint64_t{v.value()} + 1);
  }
  text += '\n';
}

std::vector<Warning> append_deck_nodes(Pieces& pieces, const Model& model) {
  std::string& text = pieces.text();
  FittedCoordinates coordinates(kDeckWidth);
  text += std::string("*NODE, NSET=") + kDeckNodes + '\n';
  for (const VertexId v : model.points.ids()) {
    append_number(text, std::uint64_t{v.value()} + 1);
    const Point3& p = model.points[v];
    for (const double c : {p.x, p.y, p.z}) text += ", " + coordinates.text_of(c);
    text += '\n';
    pieces.next();
  }
  return coordinates.warnings();
}

// A set for each component, and one of all.
void append_deck_elements(Pieces& pieces, const Model& model,
                          const std::vector<ComponentGroup>& groups,
                          const std::vector<std::string>& labels) {
  std::string& text = pieces.text();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    text += "*ELEMENT, TYPE=C3D4, ELSET=" + labels[g] + '\n';
    for (const TetId t : groups[g].tets) {
      append_deck_ids(text, t.index() + 1, model.tets[t]);
      pieces.next();
    }
  }
  if (groups.empty()) return;
  text += std::string("*ELSET, ELSET=") + kDeckElements + '\n';
  for (const std::string& label : labels) {
    text += label + '\n';
    pieces.next();
  }
}

// "tet, face" for each triangle of the boundary.
void append_deck_faces(Pieces& pieces, const Model& model, const Surface& surface,
                       const std::vector<std::size_t>& triangles, const std::string& name) {
  std::string& text = pieces.text();
  text += "*SURFACE, TYPE=ELEMENT, NAME=" + name + '\n';
  for (const std::size_t i : triangles) {
    const TetVertices& tet = model.tets[surface.tet[i]];
    const TriangleVertices& face = surface.triangles[i];
    std::size_t opposite = 0;
    while (opposite < 3 && std::find(face.begin(), face.end(), tet[opposite]) != face.end()) {
      ++opposite;
    }
    append_number(text, surface.tet[i].index() + 1);
    text += std::string(", ") + kDeckFaces[opposite] + '\n';
    pieces.next();
  }
}

// All of the boundary, and where there are several components that of each.
void append_deck_surfaces(Pieces& pieces, const Model& model, const Surface& surface,
                          const std::vector<ComponentGroup>& groups,
                          const std::vector<std::string>& labels) {
  std::vector<std::size_t> all(surface.triangles.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  append_deck_faces(pieces, model, surface, all, kDeckBoundary);
  if (groups.size() < 2) return;
  const IdVector<TetId, std::size_t> group = group_places(model, groups);
  std::vector<std::vector<std::size_t>> parts(groups.size());
  for (const std::size_t i : all) parts[group[surface.tet[i]]].push_back(i);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (parts[g].empty()) continue;
    append_deck_faces(pieces, model, surface, parts[g], labels[g] + '_' + kDeckBoundary);
  }
}

void append_deck_boundary_nodes(Pieces& pieces, const Model& model, const Surface& surface) {
  IdVector<VertexId, bool> on(model.points.size(), false);
  for (const TriangleVertices& triangle : surface.triangles) {
    for (const VertexId v : triangle) on[v] = true;
  }
  pieces.text() += std::string("*NSET, NSET=") + kDeckBoundaryNodes + '\n';
  for (const VertexId v : model.points.ids()) {
    if (!on[v]) continue;
    append_number(pieces.text(), std::uint64_t{v.value()} + 1);
    pieces.text() += '\n';
    pieces.next();
  }
}

Written write_abaqus(Sink& sink, const Model& model, const Target& /*target*/) {
  const std::vector<ComponentGroup> groups = component_groups(model);
  const std::vector<std::string> labels = label_names(groups, {kDeckElements});
  Pieces pieces(sink);
  std::string& text = pieces.text();
  text = "*HEADING\nMesh by tetloft\n";
  append_comments(text, "**", model, {});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    text += "** elset " + labels[g] + " is " + printable(groups[g].name) + '\n';
  }
  std::vector<Warning> warnings = append_deck_nodes(pieces, model);
  append_deck_elements(pieces, model, groups, labels);
  const Surface surface = boundary_surface(model);
  if (!surface.triangles.empty()) {
    append_deck_surfaces(pieces, model, surface, groups, labels);
    append_deck_boundary_nodes(pieces, model, surface);
  }
  pieces.finish();
  return warnings;
}

}  // namespace

extern constinit const Format abaqus_format{.name = "abaqus",
                                            .summary = "Abaqus, CalculiX",
                                            .extensions = {".inp"},
                                            .write_model = write_abaqus};

}  // namespace tetloft::internal::io
