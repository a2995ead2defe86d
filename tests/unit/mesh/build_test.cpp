// Building meshes: adjacency against an oracle, refusals, whole-mesh traversals.
#include "unit/mesh/meshes.hpp"

#include <thread>

namespace tetloft::mesh_test {
namespace {

std::set<VertexId> face_set(const TetVertices& t, std::size_t i) {
  std::set<VertexId> s(t.begin(), t.end());
  s.erase(t[i]);
  return s;
}

void expect_refused(std::size_t vertices, const Soup& soup, const std::string& part) {
  const Result<TetMesh> mesh = TetMesh::from_tets(vertices, soup);
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().code, ErrorCode::invalid_input);
  EXPECT_NE(mesh.error().message.find(part), std::string::npos) << mesh.error().message;
}

TEST(TetMeshBuild, OppositeAgreesWithComparingAllPairsOfFaces) {
  Prng random(11);
  for (int round = 0; round < 20; ++round) {
    const Grid grid{2, 2, 2};
    const Soup soup = random_part(grid, 0.7, random);
    const TetMesh mesh = make(grid.vertices(), soup);
    ASSERT_VALID(mesh);
    std::map<std::set<VertexId>, std::vector<HalfFaceId>> faces;
    for (std::size_t t = 0; t < soup.size(); ++t) {
      for (std::size_t i = 0; i < 4; ++i) {
        faces[face_set(soup[t], i)].push_back(HalfFaceId(4 * t + i));
      }
    }
    std::vector<HalfFaceId> boundary;
    for (const auto& [face, halves] : faces) {
      if (halves.size() == 1) {
        EXPECT_FALSE(mesh.opposite(halves[0]).valid());
        boundary.push_back(halves[0]);
      } else {
        ASSERT_EQ(halves.size(), 2U);
        EXPECT_EQ(mesh.opposite(halves[0]), halves[1]);
        EXPECT_EQ(mesh.opposite(halves[1]), halves[0]);
      }
    }
    std::sort(boundary.begin(), boundary.end());
    EXPECT_EQ(mesh.boundary(), boundary);
  }
}

TEST(TetMeshBuild, FaceNormalsPointOutOfAPositiveTet) {
  // Vertices at the origin and the unit points: twice the volume left of face (p, q, r)
  // as seen from o is the triple product of p − o, q − o, r − o.
  const std::array<std::array<int, 3>, 4> at{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<std::array<int, 3>, 3> d{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        d[k][j] = at[static_cast<std::size_t>(kFaceVertex[i][k])][j] - at[i][j];
      }
    }
    const int triple = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) -
                       d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0]) +
                       d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    EXPECT_GT(triple, 0) << "face " << i;
  }
}

TEST(TetMeshBuild, RefusesWhatIsNoMesh) {
  expect_refused(4, {tet(0, 1, 2, 4)}, "tet 0 names vertex 4 of 4");
  expect_refused(5, {tet(0, 1, 2, 3), tet(1, 4, 1, 3)}, "tet 1 repeats vertex 1");
  expect_refused(4, {{VertexId(0), VertexId(1), VertexId(2), VertexId()}}, "tet 0 names");
  expect_refused(5, {tet(0, 1, 2, 3), tet(0, 1, 2, 4)}, "same side of face (0, 1, 2)");
  expect_refused(4, {tet(0, 1, 2, 3), tet(0, 1, 2, 3)}, "same side");
  expect_refused(6, {tet(0, 1, 2, 3), tet(0, 2, 1, 4), tet(5, 0, 2, 1)},
                 "face (0, 1, 2) belongs to tets 0, 1 and 2");
}

TEST(TetMeshBuild, AcceptsTwoTetsOnTheSameFourVertices) {
  const TetMesh mesh = make(4, {tet(0, 1, 2, 3), tet(1, 0, 2, 3)});
  EXPECT_VALID(mesh);
  EXPECT_TRUE(mesh.boundary().empty());
  for (int v = 0; v < 4; ++v) EXPECT_EQ(mesh.classify_link(VertexId(v)), LinkKind::sphere);
}

TEST(TetMeshBuild, AcceptsNothing) {
  const TetMesh mesh = make(0, {});
  EXPECT_VALID(mesh);
  EXPECT_EQ(mesh.tet_count(), 0U);
  EXPECT_TRUE(mesh.singular_vertices().empty());
  EXPECT_EQ(mesh.components().size(), 0U);
}

TEST(TetMeshBuild, FromAdjacencyWithDeadSlotsIsTheSameMesh) {
  const Grid grid{1, 1, 2};
  const TetMesh mesh = make(grid.vertices(), grid.tets());
  Soup soup{TetVertices{}};
  std::vector<HalfFaceId> opposite(4);
  for (std::size_t t = 0; t < mesh.tet_slots(); ++t) {
    soup.push_back(mesh.vertices(TetId(t)));
    for (int i = 0; i < 4; ++i) {
      const HalfFaceId o = mesh.opposite(TetMesh::half_face(TetId(t), i));
      opposite.push_back(o.valid() ? HalfFaceId(o.value() + 4) : o);
    }
  }
  TetMesh shifted = TetMesh::from_adjacency(grid.vertices(), soup, opposite);
  EXPECT_VALID(shifted);
  EXPECT_EQ(shifted.tet_count(), 12U);
  EXPECT_EQ(shifted.tet_slots(), 13U);
  EXPECT_EQ(shifted.boundary().size(), mesh.boundary().size());
  shifted.compact();
  EXPECT_EQ(shifted.boundary(), mesh.boundary());
}

TEST(TetMeshBuild, ComponentsAgreeWithRepeatedMerging) {
  Prng random(12);
  for (int round = 0; round < 20; ++round) {
    const Grid grid{3, 2, 2};
    const TetMesh mesh = make(grid.vertices(), random_part(grid, 0.4, random));
    std::vector<std::size_t> label(mesh.tet_slots());
    for (std::size_t t = 0; t < label.size(); ++t) label[t] = t;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t h = 0; h < 4 * label.size(); ++h) {
        const HalfFaceId o = mesh.opposite(HalfFaceId(h));
        if (!o.valid() || label[h / 4] <= label[o.index() / 4]) continue;
        label[h / 4] = label[o.index() / 4];
        changed = true;
      }
    }
    std::map<std::size_t, std::size_t> number;
    for (std::size_t t = 0; t < label.size(); ++t) number.emplace(label[t], number.size());
    const auto component = mesh.components();
    for (std::size_t t = 0; t < label.size(); ++t) {
      EXPECT_EQ(component[TetId(t)].index(), number[label[t]]);
    }
  }
}

// Corner lists are made by whoever asks first.
TEST(TetMeshBuild, CornersAreTheSameForAllThreadsAndCopies) {
  const Grid grid{3, 3, 2};
  const TetMesh mesh = make(grid.vertices(), grid.tets());
  std::vector<std::vector<TetId>> stars(grid.vertices());
  for (const TetId t : IdRange<TetId>(mesh.tet_slots())) {
    for (const VertexId v : mesh.vertices(t)) stars[v.index()].push_back(t);
  }
  const auto has_stars = [&](const TetMesh& other) {
    for (std::size_t v = 0; v < stars.size(); ++v) {
      std::vector<TetId> listed;
      for (const HalfFaceId c : other.corners(VertexId(v))) listed.push_back(TetMesh::tet_of(c));
      if (listed != stars[v]) return false;
    }
    return true;
  };
  std::vector<char> same(8, 0);
  std::vector<std::thread> threads;
  for (char& own : same) {
    threads.emplace_back([&] { own = has_stars(TetMesh(mesh)) && has_stars(mesh) ? 1 : 0; });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(same, std::vector<char>(8, 1));

  TetMesh copy = mesh;
  copy.remove_tet(TetId(0U));
  EXPECT_FALSE(has_stars(copy));
  EXPECT_VALID(copy);
  EXPECT_TRUE(has_stars(mesh));
  copy = mesh;
  EXPECT_TRUE(has_stars(copy));
  const TetMesh moved = std::move(copy);
  EXPECT_TRUE(has_stars(moved));
}

}  // namespace
}  // namespace tetloft::mesh_test
