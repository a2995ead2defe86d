// Components of surfaces and their topology.
#include "unit/mesh/meshes.hpp"

namespace tetloft::mesh_test {
namespace {

std::vector<TriangleVertices> boundary_triangles(const TetMesh& mesh) {
  std::vector<TriangleVertices> result;
  for (const HalfFaceId h : mesh.boundary()) result.push_back(mesh.face_vertices(h));
  return result;
}

TEST(SurfaceComponents, OfACubeAreOneSphere) {
  const Grid grid{3, 3, 3};
  const SurfaceComponents s =
      surface_components(boundary_triangles(make(grid.vertices(), grid.tets())));
  ASSERT_EQ(s.topology.size(), 1U);
  EXPECT_EQ(s.topology[0].triangles, 108U);
  EXPECT_EQ(s.topology[0].edges, 162U);
  EXPECT_EQ(s.topology[0].vertices, 56U);
  EXPECT_EQ(s.topology[0].genus(), 0);
}

/// The grid without the cubes (x, y, z) where `hollow` holds.
template <class Hollow>
TetMesh without(const Grid& grid, Hollow&& hollow) {
  Soup soup;
  for (int z = 0; z < grid.nz; ++z) {
    for (int y = 0; y < grid.ny; ++y) {
      for (int x = 0; x < grid.nx; ++x) {
        if (!hollow(x, y, z)) grid.append_cube(x, y, z, soup);
      }
    }
  }
  return make(grid.vertices(), soup);
}

TEST(SurfaceComponents, HoleThroughASolidMakesGenusOne) {
  const TetMesh mesh = without({3, 3, 1}, [](int x, int y, int) { return x == 1 && y == 1; });
  const SurfaceComponents s = surface_components(boundary_triangles(mesh));
  ASSERT_EQ(s.topology.size(), 1U);
  EXPECT_EQ(s.topology[0].genus(), 1);
  EXPECT_TRUE(mesh.singular_vertices().empty());
}

TEST(SurfaceComponents, CavityIsAComponentOfItsOwn) {
  const TetMesh mesh =
      without({3, 3, 3}, [](int x, int y, int z) { return x == 1 && y == 1 && z == 1; });
  const SurfaceComponents s = surface_components(boundary_triangles(mesh));
  ASSERT_EQ(s.topology.size(), 2U);
  EXPECT_EQ(s.topology[0].triangles + s.topology[1].triangles, 120U);
  EXPECT_EQ(s.topology[1].genus(), 0);
}

TEST(SurfaceComponents, AreNumberedByTheirFirstTriangle) {
  const auto triangle = [](int a, int b, int c) -> TriangleVertices {
    return {VertexId(a), VertexId(b), VertexId(c)};
  };
  // The second and the last share edge 13 of three triangles; vertex 9 alone joins nothing.
  const std::vector<TriangleVertices> triangles{triangle(9, 8, 7), triangle(1, 3, 5),
                                                triangle(9, 11, 12), triangle(3, 1, 6),
                                                triangle(4, 1, 3)};
  const SurfaceComponents s = surface_components(triangles);
  EXPECT_EQ(s.component, (std::vector<std::uint32_t>{0, 1, 2, 1, 1}));
  ASSERT_EQ(s.topology.size(), 3U);
  EXPECT_EQ(s.topology[1].edges, 7U);
  EXPECT_EQ(s.topology[1].vertices, 5U);
  EXPECT_EQ(s.topology[1].triangles, 3U);
  EXPECT_EQ(s.topology[0].vertices, 3U);
  EXPECT_EQ(s.topology[2].vertices, 3U);
}

TEST(SurfaceComponents, OfNothingAreNone) {
  const SurfaceComponents s = surface_components({});
  EXPECT_TRUE(s.component.empty());
  EXPECT_TRUE(s.topology.empty());
}

TEST(SurfaceComponents, AgreeWithSetsOnRandomTriangles) {
  Prng random(71);
  for (int round = 0; round < 200; ++round) {
    std::vector<TriangleVertices> triangles;
    const std::size_t count = 1 + random.below(14);
    while (triangles.size() < count) {
      const TriangleVertices t{VertexId(random.below(9)), VertexId(random.below(9)),
                               VertexId(random.below(9))};
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
    }
    using Edge = std::set<VertexId>;
    const auto edges_of = [](const TriangleVertices& t) {
      return std::set<Edge>{{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}};
    };
    std::vector<std::uint32_t> label(count);
    for (std::size_t i = 0; i < count; ++i) label[i] = static_cast<std::uint32_t>(i);
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
          std::vector<Edge> common;
          const std::set<Edge> a = edges_of(triangles[i]);
          const std::set<Edge> b = edges_of(triangles[j]);
          std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
          if (common.empty() || label[i] <= label[j]) continue;
          label[i] = label[j];
          changed = true;
        }
      }
    }
    const SurfaceComponents s = surface_components(triangles);
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t i = 0; i < count; ++i) {
      number.emplace(label[i], static_cast<std::uint32_t>(number.size()));
      ASSERT_EQ(s.component[i], number[label[i]]);
    }
    ASSERT_EQ(s.topology.size(), number.size());
    for (const auto& [root, c] : number) {
      std::set<VertexId> vertices;
      std::set<Edge> edges;
      std::size_t faces = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (label[i] != root) continue;
        ++faces;
        vertices.insert(triangles[i].begin(), triangles[i].end());
        edges.merge(edges_of(triangles[i]));
      }
      EXPECT_EQ(s.topology[c].vertices, vertices.size());
      EXPECT_EQ(s.topology[c].edges, edges.size());
      EXPECT_EQ(s.topology[c].triangles, faces);
    }
  }
}

}  // namespace
}  // namespace tetloft::mesh_test
