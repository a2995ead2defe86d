// Kinds of links: known ones, and random complexes against the definitions.
#include "unit/mesh/link_oracle.hpp"
#include "unit/mesh/meshes.hpp"

namespace tetloft::mesh_test {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Tets from vertex 0 to the given triangles, which it sees from inside.
TetMesh cone(int vertices, const Triangles& link) {
  Soup soup;
  for (const std::array<int, 3>& t : link) soup.push_back(tet(0, t[0], t[1], t[2]));
  return make(static_cast<std::size_t>(vertices), soup);
}

void expect_kind(const TetMesh& mesh, LinkKind kind) {
  EXPECT_EQ(mesh.classify_link(VertexId(0)), kind);
  const auto singular = mesh.singular_vertices();
  const bool listed = !singular.empty() && singular[0] == std::pair{VertexId(0), kind};
  EXPECT_EQ(listed, !is_regular(kind));
}

TEST(LinkKind, ConeOverATriangleIsADisc) { expect_kind(cone(4, {{1, 2, 3}}), LinkKind::disc); }

TEST(LinkKind, ConeOverATetrahedronIsASphere) {
  expect_kind(cone(5, {{1, 3, 2}, {1, 2, 4}, {2, 3, 4}, {3, 1, 4}}), LinkKind::sphere);
}

TEST(LinkKind, VertexInNoTetIsEmpty) {
  const TetMesh mesh = make(1, {});
  EXPECT_EQ(mesh.classify_link(VertexId(0)), LinkKind::empty);
  EXPECT_TRUE(mesh.singular_vertices().empty());
}

TEST(LinkKind, TwoTrianglesApartAreComponents) {
  expect_kind(cone(7, {{1, 2, 3}, {4, 5, 6}}), LinkKind::singular_components);
}

TEST(LinkKind, TwoTrianglesAtAVertexArePinched) {
  expect_kind(cone(6, {{1, 2, 3}, {1, 4, 5}}), LinkKind::singular_pinch);
}

TEST(LinkKind, RingOfTrianglesPinchedInOneVertexIsPinched) {
  // A strip of triangles whose ends meet in vertex 1 only.
  expect_kind(cone(6, {{1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {4, 1, 5}}), LinkKind::singular_pinch);
}

TEST(LinkKind, AnnulusHasHoles) {
  expect_kind(cone(7, {{1, 2, 4}, {2, 5, 4}, {2, 3, 5}, {3, 6, 5}, {3, 1, 6}, {1, 4, 6}}),
              LinkKind::singular_holes);
}

TEST(LinkKind, TorusHasAHandle) {
  // Möbius's torus of seven vertices: 1 + i mod 7.
  Triangles torus;
  for (int i = 0; i < 7; ++i) {
    const auto at = [i](int k) { return 1 + (i + k) % 7; };
    torus.push_back({at(0), at(1), at(3)});
    torus.push_back({at(0), at(3), at(2)});
  }
  expect_kind(cone(8, torus), LinkKind::singular_holes);
}

TEST(LinkKind, TwoTetsAtAnEdgeMakeItSingular) {
  const TetMesh mesh = make(6, {tet(0, 1, 2, 3), tet(0, 1, 4, 5)});
  EXPECT_EQ(mesh.classify_link(VertexId(0), VertexId(1)), LinkKind::singular_components);
  EXPECT_EQ(mesh.classify_link(VertexId(0), VertexId(2)), LinkKind::disc);
  EXPECT_EQ(mesh.classify_link(VertexId(2), VertexId(4)), LinkKind::empty);
}

TEST(LinkKind, InteriorEdgeIsACycle) {
  const TetMesh mesh = make(5, {tet(0, 1, 4, 2), tet(0, 1, 2, 3), tet(0, 1, 3, 4)});
  EXPECT_EQ(mesh.classify_link(VertexId(0), VertexId(1)), LinkKind::sphere);
  EXPECT_EQ(mesh.classify_link(VertexId(2), VertexId(1)), LinkKind::disc);
}

TEST(LinkKind, AgreesWithTheDefinitionsOnRandomParts) {
  Prng random(41);
  std::map<LinkKind, int> seen;
  for (int round = 0; round < 60; ++round) {
    const Grid grid{2, 2, 2};
    const Soup soup = random_part(grid, random.between(0.1, 1), random);
    const TetMesh mesh = make(grid.vertices(), soup);
    std::vector<std::pair<VertexId, LinkKind>> singular;
    for (std::size_t i = 0; i < grid.vertices(); ++i) {
      const VertexId v(i);
      const LinkKind kind = oracle_kind_of_vertex_link(link_of(soup, {v}));
      ++seen[kind];
      ASSERT_EQ(mesh.classify_link(v), kind) << "round " << round << " vertex " << i;
      if (!is_regular(kind) && kind != LinkKind::empty) singular.emplace_back(v, kind);
    }
    EXPECT_EQ(mesh.singular_vertices(), singular);
  }
  for (const LinkKind kind :
       {LinkKind::disc, LinkKind::sphere, LinkKind::empty, LinkKind::singular_components,
        LinkKind::singular_pinch, LinkKind::singular_holes}) {
    EXPECT_GT(seen[kind], 0) << static_cast<int>(kind);
  }
}

TEST(LinkKind, OfEdgesAgreesWithTheDefinitionsOnRandomParts) {
  Prng random(42);
  std::map<LinkKind, int> seen;
  for (int round = 0; round < 20; ++round) {
    const Grid grid{2, 2, 1};
    const Soup soup = random_part(grid, random.between(0.2, 1), random);
    const TetMesh mesh = make(grid.vertices(), soup);
    for (std::size_t i = 0; i < grid.vertices(); ++i) {
      for (std::size_t j = 0; j < grid.vertices(); ++j) {
        if (i == j) continue;
        const LinkKind kind = oracle_kind_of_edge_link(link_of(soup, {VertexId(i), VertexId(j)}));
        ++seen[kind];
        ASSERT_EQ(mesh.classify_link(VertexId(i), VertexId(j)), kind);
      }
    }
  }
  EXPECT_GT(seen[LinkKind::singular_components], 0);
  EXPECT_GT(seen[LinkKind::sphere], 0);
}

}  // namespace
}  // namespace tetloft::mesh_test
