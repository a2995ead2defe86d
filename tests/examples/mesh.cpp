// Editing a tetrahedral mesh, and asking whether it is still a manifold.
#include <cstdio>
#include <vector>

#include <tetloft/tet_mesh.hpp>

using tetloft::VertexId;

namespace {

tetloft::TetVertices tet(int a, int b, int c, int d) {
  return {VertexId(a), VertexId(b), VertexId(c), VertexId(d)};
}

void tell(const char* when, const tetloft::TetMesh& mesh) {
  std::printf("%s: %zu tets, %zu boundary faces, %zu singular vertices\n", when, mesh.tet_count(),
              mesh.boundary().size(), mesh.singular_vertices().size());
}

}  // namespace

int main() {
  // Two tets at a face; a mesh knows no coordinates, only how its tets hang together.
  const std::vector<tetloft::TetVertices> tets{tet(0, 1, 2, 3), tet(0, 2, 1, 4)};
  auto mesh = tetloft::TetMesh::from_tets(5, tets);
  if (!mesh) return 1;
  tell("two tets", *mesh);

  // One that meets them in an edge alone: the link of that edge falls into two pieces.
  mesh->add_vertices(2);
  const auto added = mesh->add_tet(tet(3, 0, 5, 6));
  if (!added) return 1;
  tell("and one at an edge", *mesh);
  const tetloft::LinkKind link = mesh->classify_link(VertexId(0), VertexId(3));
  std::printf("edge 0 3 is %s\n", is_regular(link) ? "regular" : "singular");

  // What does not fit is refused, and the mesh stays as it was.
  const auto third = mesh->add_tet(tet(0, 1, 2, 5));
  std::printf("a third tet at a face: %s\n", third ? "taken" : third.error().message.c_str());

  mesh->remove_tet(*added);
  mesh->compact();
  tell("without it", *mesh);
  return mesh->validate().empty() ? 0 : 1;
}
