// Guarantee 1: every face in at most two tets, every vertex link a disc or a sphere
// (Nonato et al. 2000, section 5).
#include "check/manifold.hpp"

#include <tetloft/tet_mesh.hpp>

namespace tetloft::internal::checking {

namespace {

const char* reason(LinkKind kind) {
  switch (kind) {
    case LinkKind::singular_components: return "link in several parts";
    case LinkKind::singular_pinch: return "link pinched at a vertex";
    case LinkKind::singular_holes: return "link with holes or handles";
    default: return "link";
  }
}

}  // namespace

Findings check_manifold(const ModelView& view, const CheckOptions& options) {
  Findings findings(1, "manifold", options.places);
  for (const TetId t : view.malformed) {
    findings.fail(1, "a tet's vertices are not four distinct vertices of the model",
                  [&] { return tet_text(t); });
  }
  for (const TriangleVertices& face : view.crowded_faces) {
    findings.fail(2, "a face belongs to more than two tets", [&] { return face_text(view, face); });
  }
  for (const TriangleVertices& face : view.doubled_faces) {
    findings.fail(3, "the two tets of a face lie on the same side of it",
                  [&] { return face_text(view, face); });
  }
  // Links are defined by adjacency, which faces of three tets do not have.
  if (findings.pass() && !view.tets.empty()) {
    const TetMesh mesh = TetMesh::from_adjacency(view.points.size(), view.tets, view.opposite);
    for (const auto& [v, kind] : mesh.singular_vertices()) {
      if (!view.judges(v)) continue;
      findings.fail(4, "a vertex link is neither disc nor sphere",
                    [&, at = v, how = kind] { return vertex_text(view, at) + ": " + reason(how); });
    }
  }
  for (std::size_t v = 0; v < view.points.size(); ++v) {
    // A spare vertex in a section plane violates re-sampling (2.10), not this.
    if (view.used[v] == 0 && !on_plane(view.level[v]) && view.judges(VertexId(v))) {
      findings.fail(5, "a vertex belongs to no tet",
                    [&] { return vertex_text(view, VertexId(v)); });
    }
  }
  return findings;
}

}  // namespace tetloft::internal::checking
